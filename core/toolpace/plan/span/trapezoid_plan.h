#pragma once
/// The fastest plan without a jerk limit.

#include <vector>

#include "toolpace/limits/speed_limits.h"
#include "toolpace/plan/motion_plan.h"

namespace toolpace::detail {

/// Exact optimum under caps and accelerations, with every block's own limits: full acceleration, cruise, full deceleration.
/// Pieces of equal acceleration that follow one another are one phase.
/// @param cap  of the nodes, no higher than either neighbour's feed [mm/s]
/// @source the two-pass scan of time-optimal path following, Bobrow et al. 1985, in q = v²
MotionPlan plan_trapezoids(const SpeedLimits& limits, const std::vector<double>& cap);

}  // namespace toolpace::detail
