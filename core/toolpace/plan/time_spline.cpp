#include "toolpace/plan/time_spline.h"

#include <algorithm>
#include <cmath>

namespace toolpace {
namespace {

/// What counts as path: X Y Z, or, where they have no share in it, the rotary axes in degrees.
AxisVector along_path(const AxisVector& v, bool linear) {
  AxisVector r = AxisVector::Zero();
  if (linear) {
    r.head<3>() = v.head<3>();
  } else {
    r.tail<3>() = v.tail<3>() / kRadiansPerDegree;
  }
  return r;
}

}  // namespace

SplineState evaluate(const TimeSpline& spline, double time) {
  const double u = 1 + std::max(time, 0.0) / spline.step;
  const double top = static_cast<double>(spline.points()) - 3;
  const double cell = std::clamp(std::floor(u), 1.0, top);
  const double t = std::min(u - cell, 1.0), s = 1 - t, h = spline.step;
  const double weight[4][4] = {
      {s * s * s / 6, (4 - 6 * t * t + 3 * t * t * t) / 6, (4 - 6 * s * s + 3 * s * s * s) / 6, t * t * t / 6},
      {-s * s / 2, (3 * t * t - 4 * t) / 2, (4 * s - 3 * s * s) / 2, t * t / 2},
      {s, 3 * t - 2, 1 - 3 * t, t},
      {-1, 3, -3, 1}};
  const auto axes = static_cast<std::size_t>(spline.axes);
  const double* c = spline.control.data() + (static_cast<std::size_t>(cell) - 1) * axes;
  AxisVector d[4] = {spline.rest, AxisVector::Zero(), AxisVector::Zero(), AxisVector::Zero()};
  double scale = 1;
  for (int order = 0; order < 4; ++order) {
    for (std::size_t a = 0; a < axes; ++a) {
      const double* w = weight[order];
      d[order][spline.axis[a]] =
          (w[0] * c[a] + w[1] * c[axes + a] + w[2] * c[2 * axes + a] + w[3] * c[3 * axes + a]) * scale;
    }
    scale /= h;
  }
  // Weights that sum to 1 but for rounding: a stretch at rest must not tremble.
  for (std::size_t a = 0; a < axes; ++a) {
    if (c[a] != c[axes + a] || c[a] != c[2 * axes + a] || c[a] != c[3 * axes + a]) continue;
    d[0][spline.axis[a]] = c[a];
    for (int order = 1; order < 4; ++order) d[order][spline.axis[a]] = 0.0;
  }
  const bool linear = spline.axis[0] < 3;
  const AxisVector v = along_path(d[1], linear), acc = along_path(d[2], linear), jerk = along_path(d[3], linear);
  const double speed = v.norm();
  if (!(speed > 0)) return {d[0], 0.0, acc.norm(), jerk.norm()};
  return {d[0], speed, acc.dot(v) / speed, jerk.dot(v) / speed};
}

}  // namespace toolpace
