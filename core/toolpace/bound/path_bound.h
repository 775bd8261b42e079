#pragma once
/// A time that no plan can beat.

#include "toolpace/law/law.h"
#include "toolpace/limits/speed_limits.h"

namespace toolpace {

/// Proven lower bound of the cycle time on the same path under the same caps and ramp limits, from rest to rest [s].
///
/// Speed along the path is bounded from both sides by curves with the largest acceleration that can occur: a ≤ A, and,
/// where the law keeps a jerk limit, a ≤ √(2Jv): whoever starts from rest with jerk ≤ J has gained a²/2J of speed when
/// the acceleration has come to a. (With J different from block to block the largest one counts.) The time along the
/// upper envelope of all motions is then a lower bound; without a jerk limit it is the exact optimum.
/// With one, around each cap that the envelope touches, from the peak before it to the peak behind it, the time is also
/// at least that of the fastest motion through that cap alone (bound_valley.h), whatever its acceleration there; these
/// stretches do not overlap, and each counts with the larger of its two times.
///
/// At a reversal a motion may be at rest with all its acceleration: stretches from there, and to there, are bounded as if jerk
/// had no limit.
///
/// Holds for every look-ahead and both kinds of ramps. Dwells are not in it.
/// @param law  trapezoids are not held to the jerk
/// @return 0 for an empty chain. Accuracy 1e-11 relative, rounded towards shorter times
/// @source Bobrow et al. 1985 for the envelope; the bounds by jerk are derived above and in bound_valley.h
double path_bound(const SpeedLimits& limits, LawKind law);

}  // namespace toolpace
