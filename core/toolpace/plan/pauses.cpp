#include "toolpace/plan/pauses.h"

#include <algorithm>

namespace toolpace {

MotionPlan insert_pauses(MotionPlan plan, const std::vector<Path::Pause>& pauses, const NodePositions& positions) {
  if (std::none_of(pauses.begin(), pauses.end(), [](const Path::Pause& p) { return p.duration > 0; })) return plan;
  MotionPlan result;
  result.phases.reserve(plan.phases.size() + pauses.size());
  result.splines = plan.splines;
  double delay = 0.0;
  std::size_t next = 0, next_spline = 0;
  // A plan that rests at a node goes on from that very node.
  const auto insert_up_to = [&](std::size_t node, double distance, double time) {
    while (next < pauses.size() && positions.between(node, pauses[next].node) <= distance) {
      const double duration = pauses[next].duration;
      if (duration > 0) {
        result.phases.push_back({time + delay, duration, 0, 0, 0, 0, PhaseShape::constant_jerk, pauses[next].node});
        delay += duration;
      }
      ++next;
    }
  };
  for (const Phase& phase : plan.phases) {
    if (phase.speed == 0) insert_up_to(phase.node, phase.distance, phase.begin);
    for (; next_spline < plan.splines.size() && plan.splines[next_spline].begin <= phase.begin; ++next_spline) {
      result.splines[next_spline].begin += delay;
    }
    result.phases.push_back(phase);
    result.phases.back().begin += delay;
  }
  if (!positions.empty()) insert_up_to(positions.size() - 1, 0.0, plan.cycle_time());
  return result;
}

}  // namespace toolpace
