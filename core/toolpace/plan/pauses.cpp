#include "toolpace/plan/pauses.h"

#include <algorithm>

namespace toolpace {
namespace {

// Path positions of phases and nodes are rounded apart; a phase that starts within this share of the whole path before
// the node starts at the node. Stops are at least one block apart.
constexpr double kPositionRounding = 1e-12;

}  // namespace

MotionPlan insert_pauses(MotionPlan plan, const std::vector<Path::Pause>& pauses,
                         const std::vector<double>& positions) {
  if (std::none_of(pauses.begin(), pauses.end(), [](const Path::Pause& p) { return p.duration > 0; })) return plan;
  MotionPlan result;
  result.phases.reserve(plan.phases.size() + pauses.size());
  result.splines = plan.splines;
  const double rounding = kPositionRounding * (positions.empty() ? 0.0 : positions.back());
  double delay = 0.0;
  std::size_t next = 0, next_spline = 0;
  const auto insert_up_to = [&](double distance, double time) {
    while (next < pauses.size() && positions[pauses[next].node] <= distance + rounding) {
      const double duration = pauses[next].duration;
      if (duration > 0) {
        result.phases.push_back(
            {time + delay, duration, positions[pauses[next].node], 0, 0, 0, PhaseShape::constant_jerk});
        delay += duration;
      }
      ++next;
    }
  };
  for (const Phase& phase : plan.phases) {
    if (phase.speed == 0) insert_up_to(phase.distance, phase.begin);
    for (; next_spline < plan.splines.size() && plan.splines[next_spline].begin <= phase.begin; ++next_spline) {
      result.splines[next_spline].begin += delay;
    }
    result.phases.push_back(phase);
    result.phases.back().begin += delay;
  }
  if (!positions.empty()) insert_up_to(positions.back(), plan.cycle_time());
  return result;
}

}  // namespace toolpace
