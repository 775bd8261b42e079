#pragma once
/// The ways in which a law's ramps may run across blocks, each of them a whole plan.

#include <cstdint>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/law/law.h"
#include "toolpace/limits/speed_limits.h"
#include "toolpace/plan/motion_plan.h"
#include "toolpace/plan/span/lookahead.h"
#include "toolpace/plan/span/turns.h"

namespace toolpace::detail {

/// One way of running ramps across blocks.
struct SpanMethod {
  enum class Kind : std::uint8_t {
    trapezoid,
    hull,
    seams,   ///< a hull that crosses nodes where limits change much no faster than zero acceleration there allows
    anchors  ///< ramps that end at nodes which limit the speed
  } kind;
  double seam_ratio = 1e300;  ///< by how much limits change at a seam, which may be an anchor, too
};

/// The ways to try for a law. Under limits that are the same everywhere the first is the best one.
std::vector<SpanMethod> span_methods(const SpeedLimits& limits, LawKind law);

/// What holds at nodes.
struct SpanCaps {
  std::vector<double> speed;  ///< no higher than either neighbour's feed [mm/s]
  std::vector<Turn> turns;    ///< of laws that turn back
  std::vector<Turn> resting;  ///< the same where only nodes turn that rest anyway; as `turns` where no others do
};

/// Plans that run their ramps to where `cap` lets them.
class SpanPlanner {
 public:
  SpanPlanner(const SpeedLimits& limits, LawKind law, const Monitor& monitor);

  /// The fastest of all ways, block ramps among them; in long chains the way that is the fastest on samples of them, or block
  /// ramps. Remembers which one that was.
  MotionPlan plan_whole();

  /// The way that came out best for the whole chain, and block ramps, under a window of `blocks` ≥ 1: the faster one. Never
  /// without phases unless cancelled.
  MotionPlan plan_in_window(const StopWindow& window, std::size_t blocks) const;

  /// Whether no one way is known to be the best. Under limits that are the same everywhere the hull is, and the trapezoid.
  bool has_rivals() const;

  bool is_cancelled() const { return monitor_.is_cancelled(); }

 private:
  SpanCaps own_caps() const;
  int usual_passes() const;
  void choose_by_samples();
  /// @param passes  0: nodes that limit the speed are crossed with zero acceleration
  MotionPlan plan_by(const SpanMethod& method, const SpanCaps& caps, int passes) const;
  MotionPlan plan_hull(const std::vector<double>& cap, const SpanCaps& caps, int passes) const;
  MotionPlan plan_within(const SpanMethod& method, const StopWindow& window) const;

  const SpeedLimits& limits_;
  LawKind law_;
  const Monitor& monitor_;
  std::vector<SpanMethod> methods_;
  std::size_t best_ = 0;  ///< index of the best way
};

/// Whether a plan is there and faster than another, which may be missing.
bool is_faster(const MotionPlan& plan, const MotionPlan& other);

}  // namespace toolpace::detail
