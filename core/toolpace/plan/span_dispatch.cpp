#include "toolpace/plan/span_dispatch.h"

#include <algorithm>

#include "toolpace/plan/anchored_plan.h"
#include "toolpace/plan/block_plan.h"
#include "toolpace/plan/span_lookahead.h"
#include "toolpace/plan/span_plan.h"
#include "toolpace/plan/trapezoid_plan.h"

namespace toolpace::detail {
namespace {

/// Rounds of lowering caps where a node is crossed too fast to stop in its window.
constexpr int kWindowRounds = 12;
constexpr int kPasses = 1, kPassesForOptimum = 8;

bool is_jerk_hull(LawKind law) { return law == LawKind::seven_phase || law == LawKind::time_optimal; }

MotionPlan plan_under(const SpeedLimits& limits, const std::vector<double>& cap, LawKind law, const Monitor& monitor) {
  if (law == LawKind::trapezoid) return plan_trapezoids(limits, cap);
  if (!is_jerk_hull(law)) return plan_anchored_ramps(limits, cap, law, monitor);
  return plan_span_ramps(limits, cap, law == LawKind::time_optimal ? kPassesForOptimum : kPasses, monitor);
}

/// Plans so that every node can be stopped from; no phases where that did not come to an end.
MotionPlan plan_in_windows(const SpeedLimits& limits, LawKind law, std::size_t blocks, const Monitor& monitor) {
  std::vector<double> cap = joined_caps(limits);
  if (blocks >= limits.size()) return plan_under(limits, cap, law, monitor);
  const StopWindow window(limits, law, blocks);
  window.lower(cap);
  for (int round = 0; round < kWindowRounds; ++round) {
    MotionPlan plan = plan_under(limits, cap, law, monitor);
    if (monitor.is_cancelled()) return {};
    if (window.lower_where_accelerating(plan, cap) == 0) return plan;
  }
  return {};
}

}  // namespace

MotionPlan plan_across_blocks(const SpeedLimits& limits, LawKind law, std::size_t blocks, const Monitor& monitor) {
  MotionPlan plan = plan_in_windows(limits, law, blocks, monitor);
  if (monitor.is_cancelled()) return {};
  // The hull without look-ahead under limits that are the same everywhere has no slower rival in block ramps.
  const bool is_best = law == LawKind::trapezoid || (is_jerk_hull(law) && limits.dynamics.size() == 1);
  if (is_best && blocks >= limits.size()) return plan;
  MotionPlan other = plan_block_ramps(limits, law, blocks, monitor);
  if (plan.phases.empty() || other.cycle_time() < plan.cycle_time()) return other;
  return plan;
}

}  // namespace toolpace::detail
