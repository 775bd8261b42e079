#pragma once
/// A stretch of motion as a uniform cubic B-spline in time, for motions that leave the programmed path.

#include <array>
#include <vector>

#include "toolpace/base/axes.h"
#include "toolpace/base/metric.h"
#include "toolpace/law/phase_bounds.h"

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

/// Motion `time` seconds after the spline's begin, 0 ≤ time ≤ duration.
AxisMotion evaluate(const TimeSpline& spline, double time);

/// How a motion goes along its own way.
struct Rates {
  double speed;         ///< [mm/s; deg/s where X Y Z have no share in it]
  double acceleration;  ///< the part of the acceleration vector in the direction of motion; at rest the whole
  double jerk;          ///< the same of the jerk vector
};
Rates along(const Metric& metric, const AxisMotion& motion);
/// @param motion  of this spline, which tells the metric
Rates along(const TimeSpline& spline, const AxisMotion& motion);

/// Exact least and greatest values of one axis between two times after the spline's begin, 0 ≤ from ≤ to ≤ duration [mm, rad].
PhaseBounds bounds(const TimeSpline& spline, double from, double to, std::size_t axis);

}  // namespace toolpace
