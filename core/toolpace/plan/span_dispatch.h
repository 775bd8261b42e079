#pragma once
/// Ramps across blocks for every law and look-ahead.

#include <cstddef>

#include "toolpace/base/monitor.h"
#include "toolpace/law/law.h"
#include "toolpace/limits/speed_limits.h"
#include "toolpace/plan/motion_plan.h"

namespace toolpace::detail {

/// The fastest of the ways that there are for the law. Never slower than block ramps under the same look-ahead; the trapezoid
/// without look-ahead is the exact optimum.
/// @param blocks  look-ahead, 1 … size
/// @return no phases when cancelled
MotionPlan plan_across_blocks(const SpeedLimits& limits, LawKind law, std::size_t blocks, const Monitor& monitor);

}  // namespace toolpace::detail
