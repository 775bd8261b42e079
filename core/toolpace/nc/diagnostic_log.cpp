#include "toolpace/nc/diagnostic_log.h"

#include <fmt/format.h>

#include <algorithm>

namespace toolpace::nc {

std::string excerpt_of(std::string_view text, std::size_t column) {
  std::size_t first = 0;
  if (text.size() > kExcerptLength && column > kExcerptLength / 2) {
    first = std::min(column - kExcerptLength / 2, text.size() - kExcerptLength);
    // Not from the middle of a character of several bytes.
    while (first < text.size() && (static_cast<unsigned char>(text[first]) & 0xC0u) == 0x80u) ++first;
  }
  std::size_t last = std::min(text.size(), first + kExcerptLength);
  while (last > first && last < text.size() && (static_cast<unsigned char>(text[last]) & 0xC0u) == 0x80u) --last;
  std::string excerpt(text.substr(first, last - first));
  for (char& c : excerpt) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
  }
  const std::size_t begin = excerpt.find_first_not_of(' ');
  if (begin == std::string::npos) return {};
  return excerpt.substr(begin, excerpt.find_last_not_of(' ') - begin + 1);
}

bool DiagnosticLog::add(Fault fault, const std::string& file, std::size_t line, std::string_view text) {
  if (strict_ && fault.severity == Severity::warning) fault.severity = Severity::error;
  const bool is_error = fault.severity == Severity::error;
  std::size_t& count = counts_[fault.code];
  // What is only counted is not remembered: a program may have millions of them.
  if (count < kMostOfOneCode &&
      !seen_.insert(fmt::format("{}:{}:{}:{}", file, line, fault.column, fault.code)).second) {
    return is_error;
  }
  if (is_error) ++errors_;
  if (++count > kMostOfOneCode) return is_error;
  diagnostics_.push_back({fault.severity,
                          fault.code,
                          std::move(fault.message),
                          std::move(fault.remedy),
                          {file, line, fault.column},
                          excerpt_of(text, fault.column)});
  return is_error;
}

void DiagnosticLog::finish(const std::string& file) {
  const auto note = [&](const char* code, std::string message) {
    Diagnostic& d = diagnostics_.emplace_back();
    d.severity = Severity::note;
    d.code = code;
    d.message = std::move(message);
    d.where.file = file;
  };
  for (const auto& [code, count] : counts_) {
    if (count > kMostOfOneCode)
      note("more-of-the-same", fmt::format("{} more of \"{}\"", count - kMostOfOneCode, code));
  }
  if (is_full()) note("reading-stopped", fmt::format("reading stopped after {} errors", errors_));
}

}  // namespace toolpace::nc
