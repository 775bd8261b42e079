#include "toolpace/verify/slack_rule.h"

#include <algorithm>
#include <cmath>

#include "toolpace/base/metric.h"
#include "toolpace/verify/worst.h"

namespace toolpace {
namespace {

constexpr double kRounding = 2e-7;  // [mm] of second differences

/// A limit of the axes, of all those together that move; infinite where one of them is not limited.
double together(const Path& path, const Machine& machine, double AxisLimits::*limit) {
  double square = 0;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    const bool moves = (!is_rotary(axis) && path.arcs.size() + path.splines.size() > 0) ||
                       std::any_of(path.node.begin(), path.node.end(),
                                   [&](const AxisVector& n) { return n[i] != path.node.front()[i]; });
    const double most = counted(axis, machine.axes[axis].*limit);
    if (moves) square += most * most;
  }
  return std::sqrt(square);
}

bool turns(const Path& path) {
  return std::any_of(path.node.begin(), path.node.end(), [](const AxisVector& n) { return !n.tail<3>().isZero(0); });
}

}  // namespace

SlackRule::SlackRule(const Path& path, const Machine& machine, double period)
    : period_(period),
      speed_(together(path, machine, &AxisLimits::speed)),
      acceleration_(together(path, machine, &AxisLimits::acceleration)) {
  if (!path.tellings.empty()) {
    // Rotary axes carry the tip: their limits and the linear axes' are none of its own.
    speed_ = machine.path.speed;
    acceleration_ = kUnlimited;
    return;
  }
  if (turns(path)) return;
  const PathLimits& p = machine.path;
  speed_ = std::min(speed_, p.speed);
  // Along the path, and as much again where it turns.
  acceleration_ = std::min(acceleration_, std::sqrt(2.0) * std::max(p.acceleration, p.deceleration));
}

Slack SlackRule::at(const RowStream& stream, std::size_t local, bool from_path) const {
  double square[2] = {0, 0}, chord = 0;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const auto& p = stream.rows().told(axis);
    if (p.empty()) continue;
    const double before = counted(axis, p[local] - 2 * p[local - 1] + p[local - 2]);
    const double after = counted(axis, p[local + 1] - 2 * p[local] + p[local - 1]);
    const double step = counted(axis, p[local] - p[local - 1]);
    chord += step * step;
    square[0] += before * before;
    square[1] += after * after;
  }
  const auto& rows = stream.rows();
  double ellipse = 0;
  if (!rows.speed.empty()) {
    // At most: the corrected trapezoidal rule, and what a change of jerk in between may add.
    const double change = std::abs(rows.acceleration[local] - rows.acceleration[local - 1]);
    const double way = period_ / 2 * (rows.speed[local - 1] + rows.speed[local]) + period_ * period_ / 6 * change;
    ellipse = std::max(0.0, way * way - chord);
  }
  const double difference = std::sqrt(std::max(square[0], square[1])), most = acceleration_ * period_ * period_;
  const double fastest = speed_ * period_ * (1 + kLimitSlack) + kOnPath;
  const double half_minor = std::sqrt(ellipse) / 2;
  // What the speed changes by at a corner is shared by both second differences. One alone is off the chord by no more than a quarter
  // of both together; corners just before and behind may take from either.
  const double stepped = std::max(std::sqrt(square[0]) + std::sqrt(square[1]), half_minor);
  const bool is_bounded = difference <= most * (1 + kLimitSlack) + kRounding || chord > fastest * fastest;
  Slack slack;
  slack.at_corner = std::min(stepped, std::sqrt(std::max(0.0, fastest * fastest - chord)) / 2);
  slack.between = is_bounded ? std::min(std::max(difference, half_minor), most / 8) : difference / 7;
  slack.from_path = from_path;
  return slack;
}

}  // namespace toolpace
