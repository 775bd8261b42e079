#pragma once
/// Ramps across blocks for every law and look-ahead.

#include <cstddef>

#include "toolpace/base/monitor.h"
#include "toolpace/law/law.h"
#include "toolpace/limits/speed_limits.h"
#include "toolpace/plan/motion_plan.h"

namespace toolpace::detail {

/// Without a look-ahead (blocks = size) the fastest of the ways that there are for the law, block ramps among them; the
/// trapezoid is the exact optimum then. With one, the machine can stop inside its window at every node, and a deeper
/// look-ahead never gives a longer time: each depth's plan is kept between those of a shallower and of a deeper one, in a
/// bisection of depths that is the same whatever depth is wanted.
/// @param blocks  look-ahead, 1 … size
/// @return no phases when cancelled
MotionPlan plan_across_blocks(const SpeedLimits& limits, LawKind law, std::size_t blocks, const Monitor& monitor);

}  // namespace toolpace::detail
