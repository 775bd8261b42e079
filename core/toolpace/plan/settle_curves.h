#pragma once
/// How fast to go round curves: the cap of each, and so what it leaves for changes of speed.

#include "toolpace/base/monitor.h"
#include "toolpace/law/law.h"
#include "toolpace/limits/curve_budget.h"
#include "toolpace/limits/speed_limits.h"

namespace toolpace {

/// What the choice is made for.
struct CurveUse {
  LawKind law;
  AtCap at_cap;             ///< rests: only for plans whose ramps end inside their blocks
  std::size_t blocks = ~0;  ///< look-ahead, ≥ 1
  bool samples = false;     ///< many curves much like each other: what is tried on all of them is tried on a sample
};

/// Limits of a chain with the curves' caps and ramp limits chosen for a law.
///
/// The fastest speed round a curve leaves nothing to reach it with. So between rests (and corners that are nearly rests) the
/// curves' caps are tried at a share of their top speeds, and what they leave in several splits, the same for all, and the pair
/// is searched that makes the law's own plan of ramps inside blocks fastest; where a curve is then run through at constant
/// speed it gets its top speed, and where its cap is not reached one that is, if that saves time, too. In short runs of small
/// chains each curve's share and split is then turned by itself; of chains of thousands of curves only the share is searched,
/// from where the run before had it. Caps that the feed sets stay where they are. Where long runs are of curves much like
/// each other, what suits them is found on stretches of them. Chains without curves stay as they are; long ones cost a dozen
/// plans' scans, small ones some hundreds.
/// @param widest   of limit_speed()
/// @param monitor  once it is cancelled, what is returned is unfinished and must not be planned with
SpeedLimits settle_curves(SpeedLimits widest, const CurveUse& use, const Monitor& monitor = {});

}  // namespace toolpace
