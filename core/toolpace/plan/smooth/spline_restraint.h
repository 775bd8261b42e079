#pragma once
/// Which limit binds where a motion goes through the tube.

#include <vector>

#include "toolpace/limits/machine.h"
#include "toolpace/path/commanded.h"
#include "toolpace/plan/motion_plan.h"

namespace toolpace {

/// Restraints in which the times of the plan's splines are explained by the splines themselves.
///
/// In each knot interval the limit counts that is used most: the feed by the speed along the path, or of an axis the speed,
/// acceleration or jerk, or of the path acceleration and jerk, all by differences of control points, which is what the plan
/// is held to. Where nothing is used by nine tenths, the way through the tube is what is slow: corner. At rest: dwell.
///
/// @param restraints  consecutive, without gaps, of the whole plan (explain())
/// @param node_time   arrival at each node in the same plan
std::vector<Restraint> explain_splines(const std::vector<Restraint>& restraints, const MotionPlan& plan,
                                       const Machine& machine, const Commands& commands,
                                       const std::vector<double>& node_time);

}  // namespace toolpace
