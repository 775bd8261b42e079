#include "toolpace/plan/span_dispatch.h"

#include <algorithm>

#include "toolpace/plan/anchored_plan.h"
#include "toolpace/plan/block_plan.h"
#include "toolpace/plan/span_lookahead.h"
#include "toolpace/plan/span_plan.h"
#include "toolpace/plan/trapezoid_plan.h"

namespace toolpace::detail {
namespace {

/// Rounds of lowering caps where a node is crossed too fast to stop in its window: Newton steps first, then to speeds that
/// are safe in any case, which no node needs twice.
constexpr int kNewtonRounds = 8, kSafeRounds = 24;
/// Shorter windows whose plans are rivals of the wanted one's, and how many blocks may be planned for them in all.
constexpr std::size_t kRivals = 6, kRivalBlocks = 200000;
constexpr int kPasses = 1, kPassesForOptimum = 8;
/// By how much ramp limits may differ inside a zone; each ratio is tried for chains that are short enough.
constexpr double kZoneRatios[] = {1.3, 1.1, 1.8};
constexpr std::size_t kShortChain = 20000;

bool is_jerk_hull(LawKind law) { return law == LawKind::seven_phase || law == LawKind::time_optimal; }

bool is_slower(const MotionPlan& plan, const MotionPlan& other) {
  return !other.phases.empty() && (plan.phases.empty() || other.cycle_time() < plan.cycle_time());
}

MotionPlan plan_hull(const SpeedLimits& limits, const std::vector<double>& cap, LawKind law, const Monitor& monitor) {
  const int passes = law == LawKind::time_optimal ? kPassesForOptimum : kPasses;
  MotionPlan plan = plan_span_ramps(limits, cap, passes, monitor);
  if (limits.dynamics.size() == 1) return plan;
  if (limits.size() <= kShortChain) {
    MotionPlan other = plan_anchored_ramps(limits, cap, law, monitor);
    if (is_slower(plan, other)) plan = std::move(other);
  }
  for (const double ratio : kZoneRatios) {
    MotionPlan other = plan_zoned_ramps(limits, cap, ratio, passes, monitor);
    if (monitor.is_cancelled()) return {};
    if (is_slower(plan, other)) plan = std::move(other);
    if (limits.size() > kShortChain) break;
  }
  return plan;
}

MotionPlan plan_under(const SpeedLimits& limits, const std::vector<double>& cap, LawKind law, const Monitor& monitor) {
  if (law == LawKind::trapezoid) return plan_trapezoids(limits, cap);
  if (is_jerk_hull(law)) return plan_hull(limits, cap, law, monitor);
  return plan_anchored_ramps(limits, cap, law, monitor);
}

/// Without a window.
MotionPlan plan_whole(const SpeedLimits& limits, LawKind law, const Monitor& monitor) {
  MotionPlan plan = plan_under(limits, joined_caps(limits), law, monitor);
  // The hull and the trapezoid under limits that are the same everywhere have no faster rival in block ramps.
  if (monitor.is_cancelled() || law == LawKind::trapezoid || (is_jerk_hull(law) && limits.dynamics.size() == 1)) {
    return plan;
  }
  MotionPlan other = plan_block_ramps(limits, law, limits.size(), monitor);
  return is_slower(plan, other) ? other : plan;
}

/// Plans so that every node can be stopped from; no phases where that did not come to an end.
MotionPlan plan_in_window(const SpeedLimits& limits, LawKind law, const StopWindow& window, const Monitor& monitor) {
  std::vector<double> cap = joined_caps(limits);
  window.lower(cap);
  for (int round = 0; round < kNewtonRounds + kSafeRounds; ++round) {
    MotionPlan plan = plan_under(limits, cap, law, monitor);
    if (monitor.is_cancelled()) return {};
    const auto step = round < kNewtonRounds ? StopWindow::Step::newton : StopWindow::Step::safe;
    if (window.lower_where_too_fast(plan, step, cap) == 0) return plan;
  }
  return {};
}

}  // namespace

MotionPlan plan_across_blocks(const SpeedLimits& limits, LawKind law, std::size_t blocks, const Monitor& monitor) {
  MotionPlan plan = plan_whole(limits, law, monitor);
  if (blocks >= limits.size() || monitor.is_cancelled()) return plan;
  const StopWindow window(limits, law, blocks);
  if (window.holds(plan)) return plan;
  plan = {};
  // What can stop in a shorter window can stop in this one: the shorter ones' plans are rivals, so that a deeper look-ahead
  // does not cost time where its own plan came out worse.
  const std::size_t rivals = std::min({blocks - 1, kRivals, kRivalBlocks / limits.size()});
  for (std::size_t n = blocks - rivals; n <= blocks && !monitor.is_cancelled(); ++n) {
    for (MotionPlan other : {plan_in_window(limits, law, StopWindow(limits, law, n), monitor),
                             plan_block_ramps(limits, law, n, monitor)}) {
      if (is_slower(plan, other)) plan = std::move(other);
    }
  }
  return plan;
}

}  // namespace toolpace::detail
