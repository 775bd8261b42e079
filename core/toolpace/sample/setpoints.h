#pragma once
/// Setpoints: where the axes are commanded to be, one row an interpolation period.

#include <array>
#include <cstdint>
#include <vector>

#include "toolpace/base/axes.h"

namespace toolpace {

/// A stretch of rows, column by column. Row k of the program stands at t = (first_row + k) · period; the last row of a
/// program, at the first period at or after the end, is the exact end.
struct Setpoints {
  std::size_t first_row = 0;
  double period = 0.001;                                 ///< [s]
  std::array<std::vector<double>, kAxisCount> position;  ///< [mm, rad]; rotary columns empty when unused
  std::vector<double> speed, acceleration, jerk;         ///< along the path [mm/s, mm/s², mm/s³]
  std::vector<std::uint32_t> line;                       ///< NC line
  /// Of the tool whose tip the program is about [mm], where it is about one: as it was last told, before that as it will be. Empty
  /// where none is told.
  std::vector<double> tool_length;

  std::size_t size() const { return speed.size(); }
  double time(std::size_t row) const { return static_cast<double>(first_row + row) * period; }
};

}  // namespace toolpace
