#include "toolpace/verify/corner_limit.h"

#include <algorithm>
#include <cmath>

#include "toolpace/base/metric.h"
#include "toolpace/limits/limit_speed.h"
#include "toolpace/verify/worst.h"

namespace toolpace {
namespace {

constexpr double kPeriods =
    3;  // from the middle of a whole period before a corner to that of one after it, and some more
constexpr double kWideDeviation = 1.0;  // [mm] of a junction, wider than any machine is set to

}  // namespace

double CornerLimit::speed(const CornerRun& run, const std::optional<CornerOptions>& rule) const {
  const auto under = [&](const CornerOptions& corner) {
    return corner_speed(corner, run.arriving, run.leaving, machine_) * (1 + kLimitSlack);
  };
  if (rule && (rule->step || (rule->rule != CornerRule::blend && rule->rule != CornerRule::smooth)))
    return under(*rule);
  if (Metric::apart().dot(run.arriving, run.leaving) >= 0) return kUnlimited;
  const CornerOptions servo{.rule = CornerRule::servo};
  const CornerOptions junction{.rule = CornerRule::junction, .junction_deviation = kWideDeviation};
  return std::max(under(servo), under(junction));
}

/// What the machine allows along a direction, speeding up or slowing down.
double CornerLimit::acceleration_along(const AxisVector& direction) const {
  double most = std::max(machine_.path.acceleration, machine_.path.deceleration);
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    const double share = std::abs(direction[static_cast<Eigen::Index>(k)]);
    if (share > 0) most = std::min(most, machine_.axes[k].acceleration / share);
  }
  return most;
}

CornerPassage CornerLimit::passage(const CornerRun& run, double period,
                                   const std::optional<CornerOptions>& rule) const {
  const double slow = std::min(run.before, run.after), fast = std::max(run.before, run.after);
  const double most = run.is_straight
                          ? kPeriods * std::max(acceleration_along(run.arriving), acceleration_along(run.leaving))
                          : kUnlimited;
  const double change = std::min((fast - slow) / (period * period), most);
  const double passed = std::min((fast + (fast - slow)) / period, slow / period + most * period);
  return {std::min(passed, speed(run, rule)), change};
}

}  // namespace toolpace
