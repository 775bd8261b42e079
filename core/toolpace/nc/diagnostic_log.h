#pragma once
/// Collects what is wrong with a program, each thing once, and not without end.

#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "toolpace/nc/fault.h"

namespace toolpace::nc {

inline constexpr std::size_t kMostOfOneCode = 100;  ///< of one code; the rest is counted
inline constexpr std::size_t kMostErrors = 500;     ///< after so many the program is not read further
inline constexpr std::size_t kExcerptLength = 80;

class DiagnosticLog {
 public:
  DiagnosticLog(Diagnostics& diagnostics, bool strict) : diagnostics_(diagnostics), strict_(strict) {}

  /// @return true if it was an error (in strict reading warnings are)
  bool add(Fault fault, const std::string& file, std::size_t line, std::string_view text);
  /// Says how many were left out.
  void finish(const std::string& file);

  bool has_errors() const { return errors_ > 0; }
  std::size_t errors() const { return errors_; }
  bool is_full() const { return errors_ >= kMostErrors; }

 private:
  Diagnostics& diagnostics_;
  bool strict_;
  std::size_t errors_ = 0;
  std::unordered_map<std::string, std::size_t> counts_;
  std::unordered_set<std::string> seen_;
};

/// At most kExcerptLength characters of `text` around `column`, without control characters.
std::string excerpt_of(std::string_view text, std::size_t column);

}  // namespace toolpace::nc
