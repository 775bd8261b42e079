#pragma once
/// Short ways to read programs in tests.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "toolpace/nc/reader.h"

namespace toolpace::nc {

/// Reads a program; a program that leaves nothing to show fails the test.
inline Reading read_program(const std::string& text, ReadOptions options = {}, const std::string& name = "test.ngc") {
  auto reading = read_text(text, name, options);
  EXPECT_TRUE(reading.has_value()) << text;
  return reading ? std::move(*reading) : Reading{};
}

inline Reading read_as(Dialect dialect, const std::string& text) { return read_program(text, {.dialect = dialect}); }

/// "code@line:column" of every diagnostic.
inline std::vector<std::string> codes(const Reading& reading) {
  std::vector<std::string> list;
  for (const auto& d : reading.diagnostics) {
    list.push_back(d.code + "@" + std::to_string(d.where.line) + ":" + std::to_string(d.where.column));
  }
  return list;
}

inline bool has_code(const Reading& reading, const std::string& code) {
  return std::any_of(reading.diagnostics.begin(), reading.diagnostics.end(),
                     [&](const Diagnostic& d) { return d.code == code; });
}

/// X, Y, Z of a row's end.
inline std::vector<double> xyz(const Moves& moves, std::size_t row) {
  return {moves.end[row][0], moves.end[row][1], moves.end[row][2]};
}

/// Ends of the motion rows along one axis, rounded to 1e-9.
inline std::vector<double> ends(const Reading& reading, int axis = 0) {
  std::vector<double> list;
  for (std::size_t i = 0; i < reading.moves.size(); ++i) {
    if (is_motion(reading.moves.kind[i])) list.push_back(std::round(reading.moves.end[i][axis] * 1e9) / 1e9);
  }
  return list;
}

using Codes = std::vector<std::string>;
using Values = std::vector<double>;

}  // namespace toolpace::nc
