#pragma once
/// How the text of a trace is laid out: separator, decimal mark, names of columns, where its rows begin.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "toolpace/base/result.h"
#include "toolpace/verify/line_reader.h"

namespace toolpace::detail {

struct TraceLayout {
  char separator = ',';                    ///< ' ' stands for any number of blanks and tabs
  std::vector<std::string> names;          ///< one a column; empty where the file has none
  std::vector<std::string> units;          ///< of a line of their own; may be empty
  bool is_twincat = false;                 ///< columns called "Name" are times in ms
  std::uint64_t body = 0;                  ///< place of the first row
  std::size_t body_line = 0;               ///< lines before it
  std::vector<std::vector<double>> begin;  ///< the first rows, for guesses
};

/// Finds the first two lines of numbers, and the names above them. Reads of `lines` what it needs; go to `body` afterwards.
/// Errors: those of LineReader; input: trace-empty, trace-broken where there are no rows of numbers.
Result<TraceLayout> find_layout(LineReader& lines, const std::string& file);

/// The fields of a line, without quotes and blanks around them.
std::vector<std::string_view> split_line(std::string_view line, char separator);

/// A number at the begin of a text, with decimal point or, where `separator` is none, decimal comma.
/// @return how many characters it takes; 0 where there is none
std::size_t take_number(std::string_view text, char separator, double& value);

}  // namespace toolpace::detail
