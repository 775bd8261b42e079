#include "toolpace/plan/time_spline.h"

#include <algorithm>
#include <cmath>

#include "toolpace/base/metric.h"

namespace toolpace {
namespace {

constexpr double kEnd = 1e-9;  // of a cell: times are rounded

/// Weights of the four control points of a cell for the value and its derivatives by t, 0 ≤ t ≤ 1 in the cell.
struct CellWeights {
  double of[4][4];

  explicit CellWeights(double t) {
    const double s = 1 - t;
    const double weights[4][4] = {
        {s * s * s / 6, (4 - 6 * t * t + 3 * t * t * t) / 6, (4 - 6 * s * s + 3 * s * s * s) / 6, t * t * t / 6},
        {-s * s / 2, (3 * t * t - 4 * t) / 2, (4 * s - 3 * s * s) / 2, t * t / 2},
        {s, 3 * t - 2, 1 - 3 * t, t},
        {-1, 3, -3, 1}};
    std::copy(&weights[0][0], &weights[0][0] + 16, &of[0][0]);
  }
};

struct Place {
  std::size_t cell;
  double t;  ///< in the cell, 0 … 1
};

Place place_of(const TimeSpline& spline, double time) {
  const double u = 1 + std::max(time, 0.0) / spline.step;
  const double cell = std::clamp(std::floor(u), 1.0, static_cast<double>(spline.points()) - 3);
  return {static_cast<std::size_t>(cell) - 1, std::min(u - cell, 1.0)};
}

}  // namespace

AxisMotion evaluate(const TimeSpline& spline, double time) {
  const Place place = place_of(spline, time);
  const CellWeights weight(place.t);
  const auto axes = static_cast<std::size_t>(spline.axes);
  const double* c = spline.control.data() + place.cell * axes;
  AxisVector d[4] = {spline.rest, AxisVector::Zero(), AxisVector::Zero(), AxisVector::Zero()};
  double scale = 1;
  for (int order = 0; order < 4; ++order) {
    for (std::size_t a = 0; a < axes; ++a) {
      const double* w = weight.of[order];
      d[order][spline.axis[a]] =
          (w[0] * c[a] + w[1] * c[axes + a] + w[2] * c[2 * axes + a] + w[3] * c[3 * axes + a]) * scale;
    }
    scale /= spline.step;
  }
  // Weights that sum to 1 but for rounding: a stretch at rest must not tremble.
  for (std::size_t a = 0; a < axes; ++a) {
    if (c[a] != c[axes + a] || c[a] != c[2 * axes + a] || c[a] != c[3 * axes + a]) continue;
    d[0][spline.axis[a]] = c[a];
    for (int order = 1; order < 4; ++order) d[order][spline.axis[a]] = 0.0;
  }
  // It rests at its ends, which are control points to the bit.
  const bool has_begun = time > 0, has_ended = place.cell + 4 == spline.points() && place.t >= 1 - kEnd;
  for (std::size_t a = 0; a < axes && (!has_begun || has_ended); ++a)
    d[0][spline.axis[a]] = c[has_ended ? 3 * axes + a : a];
  return {d[0], d[1], d[2], d[3]};
}

Rates along(const TimeSpline& spline, const AxisMotion& motion) {
  return along(Metric::along(is_rotary(static_cast<std::size_t>(spline.axis[0]))), motion);
}

Rates along(const Metric& metric, const AxisMotion& motion) {
  const double speed = metric.norm(motion.speed);
  if (!(speed > 0)) return {0.0, metric.norm(motion.acceleration), metric.norm(motion.jerk)};
  return {speed, metric.dot(motion.acceleration, motion.speed) / speed, metric.dot(motion.jerk, motion.speed) / speed};
}

PhaseBounds bounds(const TimeSpline& spline, double from, double to, std::size_t axis) {
  const auto i = static_cast<Eigen::Index>(axis);
  const auto state = [&](double time) {
    const AxisMotion m = evaluate(spline, time);
    return PhaseState{m.position[i], m.speed[i], m.acceleration[i], m.jerk[i]};
  };
  constexpr double kOnKnot = 1e-9;  // of a cell
  PhaseBounds box = PhaseBounds::nothing();
  // In a cell jerk is constant and acceleration linear; speed has its vertex where acceleration passes 0.
  for (double begin = from;;) {
    const double knot = (std::floor(begin / spline.step + kOnKnot) + 1) * spline.step;
    const double end = std::min(knot, to), half = (end - begin) / 2;
    const PhaseState middle = state(begin + half);
    const double first = middle.acceleration - middle.jerk * half, last = middle.acceleration + middle.jerk * half;
    box.jerk.add(middle.jerk);
    box.acceleration.add(first);
    box.acceleration.add(last);
    box.speed.add(state(begin).speed);
    box.speed.add(state(end).speed);
    if (first * last < 0) box.speed.add(state(begin - first / middle.jerk).speed);
    if (end >= to) break;
    begin = end;
  }
  return box;
}

}  // namespace toolpace
