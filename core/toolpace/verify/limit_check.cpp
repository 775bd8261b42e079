#include "toolpace/verify/limit_check.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "toolpace/base/metric.h"

namespace toolpace {
namespace {

constexpr double kWayUlps = 16;       // of the path length that a position was computed from
constexpr double kGeometryUlps = 64;  // of centres, radii and coordinates
constexpr double kPhaseGap = 4e-13;   // of the extent: phases of a plan meet as exactly as their lengths were solved
constexpr double kUnknownRadii = 8;   // without a program arcs may have radii so many times the largest coordinate

}  // namespace

LimitCheck::LimitCheck(const Machine& machine, double period, std::optional<double> extent)
    : machine_(machine), period_(period), extent_(extent), path_speed_(machine.path.speed) {
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const AxisLimits& limits = machine.axes[axis];
    axes_[axis].speed = Worst(limits.speed);
    axes_[axis].acceleration = Worst(limits.acceleration);
    axes_[axis].jerk = Worst(limits.jerk);
    axes_[axis].low = Worst(-limits.travel_min);  // as the largest −position
    axes_[axis].high = Worst(limits.travel_max);
  }
}

double LimitCheck::noise(const AxisState& state) const {
  const double extent = extent_ ? std::max(*extent_, state.largest) : kUnknownRadii * state.largest;
  return kEpsilon * kWayUlps * way_ + (kEpsilon * kGeometryUlps + kPhaseGap) * extent;
}

double LimitCheck::noise() const {
  double largest = 0.0;
  for (const auto& state : axes_) largest = std::max(largest, noise(state));
  return largest;
}

void LimitCheck::take(const RowStream& stream, CornerExemption& corners) {
  take_path_speed(stream);
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (!stream.rows().position[axis].empty()) take_axis(stream, corners, axis);
  }
}

void LimitCheck::take_path_speed(const RowStream& stream) {
  for (std::size_t i = stream.begin(); i < stream.end(); ++i) {
    AxisVector change;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis)
      change[static_cast<Eigen::Index>(axis)] = stream.rows().told_step(axis, i);
    const double length = Metric::along(change.head<3>().isZero(0.0)).norm(change);
    way_ += length;
    const double speed = length / period_;
    if (path_speed_.would_take(speed, 0.0))
      path_speed_.take(speed, 2 * kEpsilon * kGeometryUlps * way_ / period_, stream, i);
  }
}

void LimitCheck::take_axis(const RowStream& stream, CornerExemption& corners, std::size_t axis) {
  AxisState& state = axes_[axis];
  const auto k = static_cast<Eigen::Index>(axis);
  const double* const p = stream.rows().position[axis].data();
  for (std::size_t i = stream.begin() - 1; i < stream.end() + 2; ++i)
    state.largest = std::max(state.largest, std::abs(p[i]));
  state.used = true;
  const double u = noise(state);
  const double per = 1 / period_, per2 = per * per, per3 = per2 * per;
  const double speed_bound = 2 * u * per, acceleration_bound = 4 * u * per2, jerk_bound = 8 * u * per3;
  const double acceleration_limit = threshold(state.acceleration.check().limit, acceleration_bound);
  const double jerk_limit = threshold(state.jerk.check().limit, jerk_bound);
  for (std::size_t i = stream.begin(); i < stream.end(); ++i) {
    const double d0 = p[i] - p[i - 1], d1 = p[i + 1] - p[i], d2 = p[i + 2] - p[i + 1];
    const double speed = std::abs(d0) * per;
    double acceleration = std::abs(d1 - d0) * per2;
    double jerk = std::abs((d2 - d1) - (d1 - d0)) * per3;
    if (acceleration > acceleration_limit) {
      acceleration = std::max(0.0, acceleration - corners.explain(stream, i, 2, noise()).speed_step[k] * per);
    }
    if (jerk > jerk_limit) {
      const Allowance steps = corners.explain(stream, i, 3, noise());
      const double explained = steps.speed_step[k] * per2 + steps.acceleration_step[k] * per;
      state.largest_allowance = std::max(state.largest_allowance, explained);
      jerk = std::max(0.0, jerk - explained);
    }
    if (state.speed.would_take(speed, speed_bound)) state.speed.take(speed, speed_bound, stream, i);
    if (state.acceleration.would_take(acceleration, acceleration_bound))
      state.acceleration.take(acceleration, acceleration_bound, stream, i);
    if (state.jerk.would_take(jerk, jerk_bound)) state.jerk.take(jerk, jerk_bound, stream, i + 1);
    if (state.high.would_take(p[i], u) || !stream.is_real(i - 1)) state.high.take(p[i], u, stream, i);
    if (state.low.would_take(-p[i], u) || !stream.is_real(i - 1)) state.low.take(-p[i], u, stream, i);
  }
}

void LimitCheck::report(VerifyReport& report) const {
  double resolution = 0.0;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const AxisState& state = axes_[axis];
    if (!state.used) continue;
    report.checks.push_back(state.speed.named(CheckKind::axis_speed, axis));
    report.checks.push_back(state.acceleration.named(CheckKind::axis_acceleration, axis));
    report.checks.push_back(state.jerk.named(CheckKind::axis_jerk, axis));
    Check low = state.low.named(CheckKind::travel_min, axis);
    low.value = -low.value;
    low.limit = -low.limit;
    report.checks.push_back(low);
    report.checks.push_back(state.high.named(CheckKind::travel_max, axis));
    // A position moved by δ changes some third difference by at least 2δ, and it was within the limit before.
    const double jerk = machine_.axes[axis].jerk + state.largest_allowance;
    resolution = std::max(resolution, jerk * period_ * period_ * period_ + 8 * noise(state));
  }
  report.checks.push_back(path_speed_.named(CheckKind::path_speed));
  report.position_resolution = std::min(report.position_resolution, resolution);
}

}  // namespace toolpace
