#include "toolpace/base/error_text.h"

#include <fmt/format.h>

namespace toolpace {
namespace {

std::string place(const Location& where) {
  if (where.file.empty()) return "";
  if (where.line == 0) return where.file + ": ";
  if (where.column == 0) return fmt::format("{}:{}: ", where.file, where.line);
  return fmt::format("{}:{}:{}: ", where.file, where.line, where.column);
}

std::string indented(const std::string& line) { return line.empty() ? "" : fmt::format("  {}\n", line); }

}  // namespace

const char* severity_word(Severity severity) {
  switch (severity) {
    case Severity::note: return "note";
    case Severity::warning: return "warning";
    case Severity::error: break;
  }
  return "error";
}

std::string error_text(const Error& error) {
  return diagnostic_text({Severity::error, error.code, error.message, error.remedy, error.where, {}});
}

std::string diagnostic_text(const Diagnostic& d) {
  return fmt::format("{}{}: {} [{}]\n", place(d.where), severity_word(d.severity), d.message, d.code) +
         indented(d.excerpt) + indented(d.remedy);
}

}  // namespace toolpace
