#include "toolpace/plan/span/dispatch.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "toolpace/plan/block/block_plan.h"
#include "toolpace/plan/span/lookahead.h"
#include "toolpace/plan/span/methods.h"

namespace toolpace::detail {
namespace {

/// Depths whose plans' times differ by no more than this share have one plan, the shallower one's.
constexpr double kSameTime = 1e-4;
/// Blocks of a short chain, and how far the depths are apart that are planned for one: at first each, later by ratio.
constexpr std::size_t kShallow = 64, kDepthsApart = 8;
/// Room for rounding where a plan is slowed down to another's time.
constexpr double kStretchMargin = 1e-14;

using SharedPlan = std::shared_ptr<MotionPlan>;

/// The same motion along the path in `share` times the time. Speeds, accelerations and jerks fall, and so does the way to a
/// stop from anywhere.
void stretch_time(double share, MotionPlan& plan) {
  const double rate = 1 / share;
  for (Phase& p : plan.phases) {
    p.begin *= share;
    p.duration *= share;
    p.speed *= rate;
    p.acceleration *= rate * rate;
    p.rate *= p.shape == PhaseShape::constant_jerk ? rate * rate * rate : rate;
  }
}

/// Finds the plan of one depth.
///
/// None of the methods is monotone in its caps, so that a deeper look-ahead may come out slower. In short chains for which
/// there are rival methods the fastest plan of all shallower depths is taken: it can stop inside the wider window, too. In
/// others the plan lies between those of a shallower and of a deeper one, in a tree of depths that is the same whatever depth
/// is looked for: it is made no faster than the one at the deep end of its bracket, and no slower than the one at the shallow
/// end. For any two depths the tree has a node that parts them; so of the two the deeper one's plan is never the slower one.
class DepthSearch {
 public:
  DepthSearch(const SpeedLimits& limits, LawKind law, const Monitor& monitor)
      : limits_(limits), law_(law), monitor_(monitor), planner_(limits, law, monitor) {}

  MotionPlan run(std::size_t blocks) {
    std::size_t deep = limits_.size(), shallow = 0;
    if (deep <= kShallow && planner_.has_rivals()) return run_through(blocks);
    SharedPlan fast = std::make_shared<MotionPlan>(planner_.plan_whole()), slow;
    if (blocks >= deep) return std::move(*fast);
    while (deep - shallow > 1 && !planner_.is_cancelled()) {
      const std::size_t middle = part(shallow, deep);
      SharedPlan plan = plan_between(slow, fast, middle);
      (middle <= blocks ? shallow : deep) = middle;
      (middle <= blocks ? slow : fast) = std::move(plan);
      if (slow && slow->cycle_time() <= fast->cycle_time() * (1 + kSameTime)) break;
    }
    return planner_.is_cancelled() || !slow ? MotionPlan{} : std::move(*slow);
  }

 private:
  /// What a block more gains falls with the depth: brackets are parted by ratio.
  static std::size_t part(std::size_t shallow, std::size_t deep) {
    const double mean = std::sqrt(static_cast<double>(std::max<std::size_t>(shallow, 1)) * static_cast<double>(deep));
    return std::clamp(static_cast<std::size_t>(mean), shallow + 1, deep - 1);
  }

  /// The fastest of the plans for all of a list of depths that are not deeper. The whole chain's own plan is among them
  /// from the first depth on whose windows it can stop in.
  MotionPlan run_through(std::size_t blocks) {
    const MotionPlan whole = planner_.plan_whole();
    MotionPlan best;
    if (blocks >= limits_.size()) best = whole;
    const std::size_t deepest = std::min(blocks, limits_.size() - 1);
    for (std::size_t depth = 1; depth <= deepest && !planner_.is_cancelled(); depth += 1 + depth / kDepthsApart) {
      const StopWindow window(limits_, law_, depth);
      const bool holds = window.holds(whole);
      if (holds && is_faster(whole, best)) best = whole;
      MotionPlan plan =
          holds ? plan_block_ramps(limits_, law_, depth, monitor_) : planner_.plan_in_window(window, depth);
      if (is_faster(plan, best)) best = std::move(plan);
    }
    return planner_.is_cancelled() ? MotionPlan{} : best;
  }

  SharedPlan plan_between(const SharedPlan& slow, const SharedPlan& fast, std::size_t blocks) const {
    const StopWindow window(limits_, law_, blocks);
    if (window.holds(*fast)) return fast;
    auto plan = std::make_shared<MotionPlan>(planner_.plan_in_window(window, blocks));
    if (slow && is_faster(*slow, *plan)) return slow;
    const double share = fast->cycle_time() / plan->cycle_time();
    if (share > 1) stretch_time(share * (1 + kStretchMargin), *plan);
    return plan;
  }

  const SpeedLimits& limits_;
  LawKind law_;
  const Monitor& monitor_;
  SpanPlanner planner_;
};

}  // namespace

MotionPlan plan_across_blocks(const SpeedLimits& limits, LawKind law, std::size_t blocks, const Monitor& monitor) {
  return DepthSearch(limits, law, monitor).run(blocks);
}

}  // namespace toolpace::detail
