#pragma once
/// Plans whose ramps run across blocks, jerk-limited with whatever acceleration at the nodes.

#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/limits/speed_limits.h"
#include "toolpace/plan/motion_plan.h"

namespace toolpace::detail {

/// The motion under the lower hull of the valleys that the caps throw, joined by the fastest bridges; the accelerations
/// at the touched nodes are then shifted to what both their bridges would like.
/// @param cap  of the nodes, no higher than either neighbour's feed [mm/s]
/// @param passes  rounds of shifting, each kept only if it saves time; 0: all touched nodes are crossed with none
/// @return no phases when cancelled
MotionPlan plan_span_ramps(const SpeedLimits& limits, const std::vector<double>& cap, int passes,
                           const Monitor& monitor);

/// The same where limits change from block to block. A hull needs limits that hold under all of it; so the chain is cut into
/// zones in which they differ by no more than `ratio`, and the seams are crossed with zero acceleration.
/// @return no phases when cancelled, where zones would be too short to gain anything or could not be joined
MotionPlan plan_zoned_ramps(const SpeedLimits& limits, const std::vector<double>& cap, double ratio, int passes,
                            const Monitor& monitor);

}  // namespace toolpace::detail
