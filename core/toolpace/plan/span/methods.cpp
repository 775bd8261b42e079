#include "toolpace/plan/span/methods.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "toolpace/plan/block/block_plan.h"
#include "toolpace/plan/span/anchor_sites.h"
#include "toolpace/plan/span/anchored_plan.h"
#include "toolpace/plan/span/span_plan.h"
#include "toolpace/plan/span/trapezoid_plan.h"

namespace toolpace::detail {
namespace {

/// Rounds of lowering caps where a node is crossed too fast to stop in its window: Newton steps, then with a gentle climb
/// behind the node, in the end without letting touched nodes be crossed with any acceleration.
constexpr int kNewtonRounds = 3, kClimbRounds = 4, kRestedRounds = 12;
constexpr int kPasses = 1, kPassesForOptimum = 8;
/// Nodes where ramp limits change by more than this are seams.
constexpr double kSeamRatio = 2.0;
/// Chains with seams that are no longer than this are planned between anchors, too: that takes long and seldom gains much.
constexpr std::size_t kShortChain = 1000;

/// In longer chains the ways are compared on samples: so many of so many blocks, evenly spread.
constexpr std::size_t kLongChain = 50000, kSamples = 8, kSampleBlocks = 500;

bool is_jerk_hull(LawKind law) { return law == LawKind::seven_phase || law == LawKind::time_optimal; }

bool has_seams(const SpeedLimits& limits) {
  for (std::size_t i = 1; i < limits.size(); ++i) {
    if (limits.ramp[i] == limits.ramp[i - 1]) continue;
    if (ratio_of(limits.dynamics_of(i - 1), limits.dynamics_of(i)) > kSeamRatio) return true;
  }
  return false;
}

}  // namespace

bool is_faster(const MotionPlan& plan, const MotionPlan& other) {
  return !plan.phases.empty() && (other.phases.empty() || plan.cycle_time() < other.cycle_time());
}

std::vector<SpanMethod> span_methods(const SpeedLimits& limits, LawKind law) {
  using Kind = SpanMethod::Kind;
  if (law == LawKind::trapezoid) return {{Kind::trapezoid}};
  if (!is_jerk_hull(law)) {
    if (limits.dynamics.size() == 1) return {{Kind::anchors}};
    return {{Kind::anchors}, {Kind::anchors, 1.0}};
  }
  if (limits.dynamics.size() == 1 || !has_seams(limits)) return {{Kind::hull}};
  if (limits.size() > kShortChain) return {{Kind::hull}, {Kind::seams, kSeamRatio}};
  return {{Kind::hull}, {Kind::seams, kSeamRatio}, {Kind::anchors, 1.0}};
}

SpanPlanner::SpanPlanner(const SpeedLimits& limits, LawKind law, const Monitor& monitor)
    : limits_(limits), law_(law), monitor_(monitor), methods_(span_methods(limits, law)) {}

/// The hull and the trapezoid under limits that are the same everywhere have no faster rival in block ramps.
bool SpanPlanner::has_rivals() const {
  return law_ != LawKind::trapezoid && !(is_jerk_hull(law_) && limits_.dynamics.size() == 1);
}

int SpanPlanner::usual_passes() const { return law_ == LawKind::time_optimal ? kPassesForOptimum : kPasses; }

SpanCaps SpanPlanner::own_caps() const {
  SpanCaps caps{joined_caps(limits_), {}, {}};
  if (!turns_back(law_) || limits_.reversals.empty()) return caps;
  caps.turns = possible_turns(limits_, caps.speed, limits_.reversals);
  std::vector<std::uint32_t> resting = limits_.reversals;
  std::erase_if(resting, [&](std::uint32_t node) { return caps.speed[node] > 0; });
  caps.resting =
      resting.size() == limits_.reversals.size() ? caps.turns : possible_turns(limits_, caps.speed, std::move(resting));
  return caps;
}

/// Nodes that rest anyway lose nothing by turning. Whether others do that could be crossed at a speed is known of the whole alone.
MotionPlan SpanPlanner::plan_hull(const std::vector<double>& cap, const SpanCaps& caps, int passes) const {
  MotionPlan plan = plan_span_ramps(limits_, cap, caps.turns, passes, monitor_);
  if (caps.resting.size() == caps.turns.size() || monitor_.is_cancelled()) return plan;
  MotionPlan other = plan_span_ramps(limits_, cap, caps.resting, passes, monitor_);
  return is_faster(other, plan) ? other : plan;
}

MotionPlan SpanPlanner::plan_by(const SpanMethod& method, const SpanCaps& caps, int passes) const {
  const std::vector<double>& cap = caps.speed;
  switch (method.kind) {
    case SpanMethod::Kind::trapezoid: return plan_trapezoids(limits_, cap);
    case SpanMethod::Kind::hull: return plan_hull(cap, caps, passes);
    case SpanMethod::Kind::seams: return plan_hull(settle_seams(limits_, cap, method.seam_ratio), caps, passes);
    case SpanMethod::Kind::anchors: break;
  }
  return plan_anchored_ramps(limits_, cap, {law_, method.seam_ratio, passes > 0}, monitor_);
}

/// The one way that is the fastest on samples of the chain.
void SpanPlanner::choose_by_samples() {
  std::vector<double> time(methods_.size(), 0.0);
  for (std::size_t k = 0; k < kSamples; ++k) {
    const std::size_t first = k * (limits_.size() - kSampleBlocks) / (kSamples - 1);
    const SpeedLimits part = slice(limits_, first, first + kSampleBlocks);
    const SpanPlanner planner(part, law_, monitor_);
    const SpanCaps caps = planner.own_caps();
    for (std::size_t m = 0; m < methods_.size(); ++m) {
      const MotionPlan plan = planner.plan_by(methods_[m], caps, usual_passes());
      time[m] += plan.phases.empty() ? std::numeric_limits<double>::infinity() : plan.cycle_time();
    }
  }
  methods_ = {methods_[static_cast<std::size_t>(std::min_element(time.begin(), time.end()) - time.begin())]};
}

MotionPlan SpanPlanner::plan_whole() {
  MotionPlan plan;
  if (methods_.size() > 1 && limits_.size() > kLongChain) choose_by_samples();
  const SpanCaps caps = own_caps();
  for (std::size_t m = 0; m < methods_.size(); ++m) {
    MotionPlan other = plan_by(methods_[m], caps, usual_passes());
    if (monitor_.is_cancelled()) return {};
    if (!is_faster(other, plan)) continue;
    plan = std::move(other);
    best_ = m;
  }
  if (!has_rivals() || (!plan.phases.empty() && plan.cycle_time() <= time_block_ramps(limits_, law_, limits_.size())))
    return plan;
  MotionPlan block = plan_block_ramps(limits_, law_, limits_.size(), monitor_);
  return is_faster(block, plan) ? block : plan;
}

MotionPlan SpanPlanner::plan_within(const SpanMethod& method, const StopWindow& window) const {
  SpanCaps caps = own_caps();
  window.lower(caps.turns, caps.speed);
  window.lower(caps.resting, caps.speed);
  window.lower(caps.speed);
  for (int round = 0; round < kNewtonRounds + kClimbRounds + kRestedRounds; ++round) {
    const int passes = round < kNewtonRounds + kClimbRounds ? usual_passes() : 0;
    MotionPlan plan = plan_by(method, caps, passes);
    if (monitor_.is_cancelled() || plan.phases.empty()) return {};
    const auto step = round < kNewtonRounds ? StopWindow::Step::newton : StopWindow::Step::climb;
    if (window.lower_where_too_fast(plan, step, caps.speed) == 0) return plan;
  }
  return {};
}

MotionPlan SpanPlanner::plan_in_window(const StopWindow& window, std::size_t blocks) const {
  // With a stop at every node there is nothing that could run across one.
  MotionPlan plan = blocks > 1 ? plan_within(methods_[best_], window) : MotionPlan{};
  MotionPlan block = plan_block_ramps(limits_, law_, blocks, monitor_);
  return is_faster(plan, block) ? plan : block;
}

}  // namespace toolpace::detail
