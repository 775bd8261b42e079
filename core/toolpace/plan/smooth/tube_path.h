#pragma once
/// What the tube planner sees: a polyline with a tolerance around it, and the limits of the axes.

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "toolpace/base/axes.h"

namespace toolpace {

/// A run of blocks without a stop, as a polyline. Coordinates are mm and, for rotary axes, degrees, so that one number can
/// be the tolerance of both. Only axes that move are kept.
struct TubePath {
  int axes = 0;                           ///< 1 … 6 coordinates a point
  int linear = 0;                         ///< the first of them that are X, Y, Z: they count for the feed (all, if 0)
  std::array<int, kAxisCount> axis = {};  ///< machine axis of each coordinate
  std::vector<double> points;             ///< axes values a vertex; neighbours differ
  std::vector<double> distance;           ///< path length from the first vertex to each [mm, deg]
  // One entry a segment:
  std::vector<double> feed;       ///< top speed [mm/s, deg/s] > 0, may be infinite
  std::vector<double> tolerance;  ///< [mm, deg] > 0

  std::size_t segments() const { return feed.size(); }
  const double* point(std::size_t i) const { return points.data() + i * static_cast<std::size_t>(axes); }
};

/// Limits of each machine axis [mm/s …, deg/s …]; infinite = none.
struct TubeLimits {
  static constexpr double kNone = std::numeric_limits<double>::infinity();
  using PerAxis = std::array<double, kAxisCount>;
  PerAxis speed = {kNone, kNone, kNone, kNone, kNone, kNone};
  PerAxis acceleration = speed;
  PerAxis jerk = speed;
  // Of the vector over the linear axes (over all, where none moves):
  double path_acceleration = kNone;
  double path_jerk = kNone;
};

}  // namespace toolpace
