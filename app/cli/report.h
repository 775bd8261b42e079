#pragma once
/// How the command line tells people what went wrong, and its exit codes.

#include "toolpace/base/result.h"

namespace toolpace::cli {

enum ExitCode : int { kFine = 0, kLimitBroken = 1, kBadUsage = 2, kBadInput = 3, kFileTrouble = 4, kInterrupted = 130 };

ExitCode exit_code(ErrorKind kind);

/// Prints "file:line:column: error: message [code]" and the remedy to stderr.
/// @return the exit code that goes with the error
int report(const Error& error);
void report(const Diagnostic& diagnostic);
void report(const Diagnostics& diagnostics);

}  // namespace toolpace::cli
