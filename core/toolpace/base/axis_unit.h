#pragma once
/// The units in which people read and write the axes, and what they are called.

#include <array>

#include "toolpace/base/axes.h"

namespace toolpace {

/// In files, flags and labels an axis' value is value / size. Texts are of position, speed, acceleration and jerk.
struct AxisUnit {
  double size;                        ///< [mm or rad], of the derivatives too
  std::array<const char*, 4> symbol;  ///< mm, mm/s, …
  std::array<const char*, 4> key;     ///< the same in keys and columns: mm, mm_s, …
};

inline constexpr AxisUnit kMillimetres = {1.0, {"mm", "mm/s", "mm/s²", "mm/s³"}, {"mm", "mm_s", "mm_s2", "mm_s3"}};
inline constexpr AxisUnit kDegrees = {
    kRadiansPerDegree, {"deg", "deg/s", "deg/s²", "deg/s³"}, {"deg", "deg_s", "deg_s2", "deg_s3"}};

constexpr const AxisUnit& axis_unit(std::size_t axis) { return is_rotary(axis) ? kDegrees : kMillimetres; }

}  // namespace toolpace
