#pragma once
/// Plans whose ramps run across blocks, jerk-limited with whatever acceleration at the nodes.

#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/limits/speed_limits.h"
#include "toolpace/plan/motion_plan.h"
#include "toolpace/plan/span/turns.h"

namespace toolpace::detail {

/// The motion under the lower hull of the valleys that the caps throw, joined by the fastest bridges; the accelerations
/// at the touched nodes are then shifted to what both their bridges would like. Where limits change from block to block each
/// bridge keeps the smallest under its span.
/// @param cap  of the nodes, no higher than either neighbour's feed [mm/s]
/// @param turns  nodes to turn or to rest at, rising; stretches that have no plan with them come to rest
/// @param passes  rounds of shifting, each kept only if it saves time; 0: all touched nodes are crossed with none
/// @return no phases when cancelled
MotionPlan plan_span_ramps(const SpeedLimits& limits, const std::vector<double>& cap, std::vector<Turn> turns,
                           int passes, const Monitor& monitor);

}  // namespace toolpace::detail
