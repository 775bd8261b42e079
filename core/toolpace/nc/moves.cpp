#include "toolpace/nc/moves.h"

#include <algorithm>

namespace toolpace {
namespace {

template <class Choose>
MotionCeiling chosen(const MotionCeiling& a, const MotionCeiling& b, Choose choose) {
  MotionCeiling c;
  for (Eigen::Index k = 0; k < c.speed.size(); ++k) {
    c.speed[k] = choose(a.speed[k], b.speed[k]);
    c.acceleration[k] = choose(a.acceleration[k], b.acceleration[k]);
    c.corner_step[k] = choose(a.corner_step[k], b.corner_step[k]);
  }
  c.path_speed = choose(a.path_speed, b.path_speed);
  c.path_acceleration = choose(a.path_acceleration, b.path_acceleration);
  c.corner_speed = choose(a.corner_speed, b.corner_speed);
  c.junction_deviation = choose(a.junction_deviation, b.junction_deviation);
  return c;
}

}  // namespace

bool MotionCeiling::limits_corners() const {
  return corner_step.minCoeff() < kNone || corner_speed < kNone || junction_deviation < kNone;
}

AxisVector Moves::begin_of(std::size_t i) const {
  const AxisVector& before = i == 0 ? start : end[i - 1];
  if (!has_tip() || i == size()) return before;
  return told_about(chains[chain_of(i)], chains[i == 0 ? 0 : chain_of(i - 1)], before);
}

MotionCeiling lower_of(const MotionCeiling& a, const MotionCeiling& b) {
  MotionCeiling c = chosen(a, b, [](double x, double y) { return std::min(x, y); });
  c.accuracy = std::max(a.accuracy, b.accuracy);
  c.holds_overrides = a.holds_overrides || b.holds_overrides;
  return c;
}

MotionCeiling higher_of(const MotionCeiling& a, const MotionCeiling& b) {
  MotionCeiling c = chosen(a, b, [](double x, double y) { return std::max(x, y); });
  c.accuracy = std::min(a.accuracy, b.accuracy);
  c.holds_overrides = a.holds_overrides && b.holds_overrides;
  return c;
}

}  // namespace toolpace
