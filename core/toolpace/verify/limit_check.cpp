#include "toolpace/verify/limit_check.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "toolpace/base/metric.h"
#include "toolpace/verify/position_corners.h"

namespace toolpace {
namespace {

constexpr double kWayUlps = 16;       // of the path length that a position was computed from
constexpr double kGeometryUlps = 64;  // of centres, radii and coordinates
constexpr double kPhaseGap = 4e-13;   // of the extent: phases of a plan meet as exactly as their lengths were solved
constexpr double kUnknownRadii = 8;   // without a program arcs may have radii so many times the largest coordinate

}  // namespace

LimitCheck::LimitCheck(const Machine& machine, double period, std::optional<double> extent)
    : machine_(machine),
      period_(period),
      corners_known_(extent.has_value()),
      extent_(extent.value_or(0.0)),
      path_speed_(machine.path.speed) {
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
  const double extent = corners_known_ ? std::max(extent_, state.largest) : kUnknownRadii * state.largest;
  return kEpsilon * kWayUlps * way_ + (kEpsilon * kGeometryUlps + kPhaseGap) * extent;
}

void LimitCheck::take(const RowStream& stream, const CornerLog& log) {
  take_path_speed(stream);
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (!stream.rows().position[axis].empty()) take_axis(stream, log, axis);
  }
}

void LimitCheck::take_path_speed(const RowStream& stream) {
  const auto& p = stream.rows().position;
  const auto step = [&p](std::size_t axis, std::size_t i) {
    return p[axis].empty() ? 0.0 : p[axis][i] - p[axis][i - 1];
  };
  for (std::size_t i = stream.begin(); i < stream.end(); ++i) {
    AxisVector change;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) change[static_cast<Eigen::Index>(axis)] = step(axis, i);
    const double length = Metric::along(change.head<3>().isZero(0.0)).norm(change);
    way_ += length;
    const double speed = length / period_;
    if (path_speed_.would_take(speed, 0.0))
      path_speed_.take(speed, 2 * kEpsilon * kGeometryUlps * way_ / period_, stream, i);
  }
}

void LimitCheck::take_axis(const RowStream& stream, const CornerLog& log, std::size_t axis) {
  AxisState& state = axes_[axis];
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
      acceleration = std::max(0.0, acceleration - allowance(stream, log, axis, i, 2).speed_step * per);
    }
    if (jerk > jerk_limit) {
      const Allowance steps = allowance(stream, log, axis, i, 3);
      const double explained = steps.speed_step * per2 + steps.acceleration_step * per;
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

LimitCheck::Allowance LimitCheck::allowance(const RowStream& stream, const CornerLog& log, std::size_t axis,
                                            std::size_t local, std::size_t intervals) {
  Allowance sum;
  const auto take = [&](const CornerEvent& event) {
    sum.speed_step += event.speed_step[static_cast<Eigen::Index>(axis)];
    sum.acceleration_step += event.acceleration_step[static_cast<Eigen::Index>(axis)];
    count_corner(event);
  };
  if (corners_known_) {
    const std::int64_t first = stream.row(local);
    log.for_each(first, first + static_cast<std::int64_t>(intervals) - 1, take);
    return sum;
  }
  double position_noise = 0.0;
  for (const auto& state : axes_) position_noise = std::max(position_noise, noise(state));
  for (std::size_t k = 0; k < intervals; ++k) {
    take(corner_between_straights(stream, local + k, period_, position_noise));
  }
  return sum;
}

void LimitCheck::count_corner(const CornerEvent& event) {
  const double step = event.speed_step.norm();
  if (step == 0.0 && event.acceleration_step.isZero(0.0)) return;
  largest_step_ = std::max(largest_step_, step);
  if (event.corner > last_corner_) ++corners_;
  last_corner_ = std::max(last_corner_, event.corner);
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
  report.exempt_corners = corners_;
  report.largest_corner_step = largest_step_;
}

}  // namespace toolpace
