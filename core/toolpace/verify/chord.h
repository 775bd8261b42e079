#pragma once
/// The straight line between two consecutive rows.

#include <cmath>
#include <numbers>

#include "toolpace/base/metric.h"
#include "toolpace/verify/row_stream.h"

namespace toolpace {

struct Chord {
  AxisVector way;  ///< [mm, rad]
  Metric metric;   ///< as lengths along a path count
  double length() const { return metric.norm(way); }
};

/// From row i − 1 to row i (local indices), as the path tells them.
inline Chord chord_to(const RowStream& stream, std::size_t i) {
  AxisVector way;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    way[static_cast<Eigen::Index>(axis)] = stream.rows().told_step(axis, i);
  }
  return {way, Metric::along(way.head<3>().isZero(0.0))};
}

/// Angle between two chords [rad]; π where one of them has no length. Exact for small ones, too (Kahan).
inline double turn(const Chord& a, const Chord& b) {
  const double la = a.length(), lb = b.length();
  if (!(a.metric == b.metric) || la == 0 || lb == 0) return std::numbers::pi;
  const AxisVector u = a.way / la, w = b.way / lb;
  return 2 * std::atan2(a.metric.norm(u - w), a.metric.norm(u + w));
}

}  // namespace toolpace
