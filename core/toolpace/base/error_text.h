#pragma once
/// Errors and diagnostics as the lines of text that every command prints.

#include <string>

#include "toolpace/base/result.h"

namespace toolpace {

/// "note", "warning" or "error".
const char* severity_word(Severity severity);

/// "file:line:column: error: message [code]" and the remedy below it, each line with its end; what is unknown of the place
/// is left out.
std::string error_text(const Error& error);

/// The same with the severity's word, and the excerpt before the remedy.
std::string diagnostic_text(const Diagnostic& diagnostic);

}  // namespace toolpace
