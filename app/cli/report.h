#pragma once
/// How the command line tells people, and scripts that asked for JSON, what went wrong.

#include "json.h"

#include "failure.h"

namespace toolpace::cli {

/// Prints to stderr, or tells the console (console.h). Where that cannot be written, there is nobody to tell.
void tell(const std::string& text);

ExitCode exit_code(ErrorKind kind);

/// Prints "file:line:column: error: message [code]" and the remedy to stderr.
/// @return the exit code that goes with the error
ExitCode report(const Error& error);
void report(const Diagnostic& diagnostic);
void report(const Diagnostics& diagnostics);

/// {"error": {code, message, remedy, file, line, column, attainable}, "exit_code", "diagnostics": […]}: what --json
/// prints instead of a result.
Json to_json(const Failure& failure);

/// [{severity, code, file, line, column, message, excerpt, remedy}, …]
Json to_json(const Diagnostics& diagnostics);

/// Prints one JSON value to stdout, or hands it to the console.
void print_json(const Json& json);

}  // namespace toolpace::cli
