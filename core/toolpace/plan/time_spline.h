#pragma once
/// A stretch of motion as a uniform cubic B-spline in time, for motions that leave the programmed path.

#include <array>
#include <vector>

#include "toolpace/base/axes.h"

namespace toolpace {

/// Starts and ends at rest: the first three and the last three control points are equal. Their differences over step,
/// step² and step³ bound the speed, acceleration and jerk of each axis for all t (convex hull property).
struct TimeSpline {
  double begin = 0;                       ///< [s]
  double step = 0.001;                    ///< between knots [s]
  int axes = 0;                           ///< coordinates a control point
  std::array<int, kAxisCount> axis = {};  ///< machine axis of each coordinate
  AxisVector rest = AxisVector::Zero();   ///< where the other axes stand [mm, rad]
  std::vector<double> control;            ///< [mm, rad]

  std::size_t points() const { return control.size() / static_cast<std::size_t>(axes); }
  /// [s]
  double duration() const { return (static_cast<double>(points()) - 3) * step; }
};

struct SplineState {
  AxisVector position;  ///< [mm, rad]
  double speed;         ///< along the path, X Y Z; where they stand still, rotary [mm/s, deg/s]
  double acceleration;  ///< the part of the acceleration vector along the path
  double jerk;          ///< the part of the jerk vector along the path
};

/// State `time` seconds after the spline's begin, 0 ≤ time ≤ duration.
SplineState evaluate(const TimeSpline& spline, double time);

}  // namespace toolpace
