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
constexpr int kNewtonRounds = 9, kSafeRounds = 24;
/// Blocks that may be planned for shorter windows, whose plans are rivals of the wanted one's. Anchored plans cost more.
constexpr std::size_t kRivalBlocks = 10000, kAnchoredRivalBlocks = 3000;
constexpr int kPasses = 1, kPassesForOptimum = 8;
/// By how much ramp limits may differ inside a zone; the later ones are tried for chains that are short enough.
constexpr double kZoneRatios[] = {1.3, 1.1, 1.8};
constexpr std::size_t kShortChain = 20000;
/// In longer chains zones are made only where limits differ by more than this, as between a fast and a slow axis.
constexpr double kWideSpread = 2.0;

bool is_jerk_hull(LawKind law) { return law == LawKind::seven_phase || law == LawKind::time_optimal; }

bool is_slower(const MotionPlan& plan, const MotionPlan& other) {
  return !other.phases.empty() && (plan.phases.empty() || other.cycle_time() < plan.cycle_time());
}

/// One way of running ramps across blocks.
struct Method {
  enum class Kind : std::uint8_t { trapezoid, hull, zones, anchors } kind;
  double ratio = 1.0;                        ///< of zones
  AnchorSites sites = AnchorSites::touched;  ///< of anchors
};

/// By how much accelerations or jerks differ over the chain, as a ratio.
double spread_of(const SpeedLimits& limits) {
  double spread = 1.0;
  for (double RampLimits::*value : {&RampLimits::acceleration, &RampLimits::jerk}) {
    for (RampLimits Dynamics::*side : {&Dynamics::up, &Dynamics::down}) {
      const auto [low, high] =
          std::minmax_element(limits.dynamics.begin(), limits.dynamics.end(),
                              [&](const Dynamics& a, const Dynamics& b) { return a.*side.*value < b.*side.*value; });
      spread = std::max(spread, (*high).*side.*value / ((*low).*side.*value));
    }
  }
  return spread;
}

/// The ways to try for a law. Under limits that are the same everywhere the first is the best one.
std::vector<Method> methods_for(const SpeedLimits& limits, LawKind law) {
  using Kind = Method::Kind;
  if (law == LawKind::trapezoid) return {{Kind::trapezoid}};
  const bool uniform = limits.dynamics.size() == 1;
  if (!is_jerk_hull(law)) {
    if (uniform) return {{Kind::anchors}};
    return {{Kind::anchors}, {Kind::anchors, 1.0, AnchorSites::touched_changed}};
  }
  if (uniform) return {{Kind::hull}};
  if (limits.size() > kShortChain) {
    if (spread_of(limits) < kWideSpread) return {{Kind::hull}};
    return {{Kind::hull}, {Kind::zones, kZoneRatios[0]}};
  }
  std::vector<Method> all = {{Kind::hull}, {Kind::anchors}, {Kind::anchors, 1.0, AnchorSites::touched_changed}};
  for (const double ratio : kZoneRatios) all.push_back({Kind::zones, ratio});
  return all;
}

/// A law, and the way in which it is planned across blocks.
struct Plan {
  const SpeedLimits& limits;
  LawKind law;
  const Monitor& monitor;

  MotionPlan by(const Method& method, const std::vector<double>& cap) const {
    const int passes = law == LawKind::time_optimal ? kPassesForOptimum : kPasses;
    switch (method.kind) {
      case Method::Kind::trapezoid: return plan_trapezoids(limits, cap);
      case Method::Kind::hull: return plan_span_ramps(limits, cap, passes, monitor);
      case Method::Kind::zones: return plan_zoned_ramps(limits, cap, method.ratio, passes, monitor);
      case Method::Kind::anchors: break;
    }
    return plan_anchored_ramps(limits, cap, law, method.sites, monitor);
  }

  /// Without a window.
  MotionPlan whole() const {
    MotionPlan plan;
    const std::vector<double> cap = joined_caps(limits);
    for (const Method& method : methods_for(limits, law)) {
      MotionPlan other = by(method, cap);
      if (monitor.is_cancelled()) return {};
      if (is_slower(plan, other)) plan = std::move(other);
    }
    // The hull and the trapezoid under limits that are the same everywhere have no faster rival in block ramps.
    if (law == LawKind::trapezoid || (is_jerk_hull(law) && limits.dynamics.size() == 1)) return plan;
    MotionPlan block = plan_block_ramps(limits, law, limits.size(), monitor);
    return is_slower(plan, block) ? block : plan;
  }

  /// So that every node can be stopped from; no phases where that did not come to an end.
  MotionPlan in_window(const Method& method, const StopWindow& window) const {
    std::vector<double> cap = joined_caps(limits);
    window.lower(cap);
    for (int round = 0; round < kNewtonRounds + kSafeRounds; ++round) {
      MotionPlan plan = by(method, cap);
      if (monitor.is_cancelled() || plan.phases.empty()) return {};
      const auto step = round < kNewtonRounds ? StopWindow::Step::newton : StopWindow::Step::safe;
      if (window.lower_where_too_fast(plan, step, cap) == 0) return plan;
    }
    return {};
  }
};

}  // namespace

MotionPlan plan_across_blocks(const SpeedLimits& limits, LawKind law, std::size_t blocks, const Monitor& monitor) {
  const Plan planner{limits, law, monitor};
  MotionPlan plan = planner.whole();
  if (blocks >= limits.size() || monitor.is_cancelled()) return plan;
  if (StopWindow(limits, law, blocks).holds(plan)) return plan;
  plan = {};
  // What can stop in a shorter window can stop in this one: the shorter ones' plans are rivals, so that a deeper look-ahead
  // does not cost time where its own plan came out worse.
  const std::vector<Method> methods = methods_for(limits, law);
  const std::size_t budget = (is_jerk_hull(law) ? kRivalBlocks : kAnchoredRivalBlocks) / methods.size();
  const std::size_t rivals = std::min(blocks - 1, budget / limits.size());
  for (std::size_t n = blocks - rivals; n <= blocks && !monitor.is_cancelled(); ++n) {
    const StopWindow window(limits, law, n);
    for (const Method& method : methods) {
      MotionPlan other = planner.in_window(method, window);
      if (is_slower(plan, other)) plan = std::move(other);
    }
    MotionPlan block = plan_block_ramps(limits, law, n, monitor);
    if (is_slower(plan, block)) plan = std::move(block);
  }
  return plan;
}

}  // namespace toolpace::detail
