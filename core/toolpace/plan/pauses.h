#pragma once
/// Dwells and other pauses, put into a plan at the nodes where the machine rests.

#include <vector>

#include "toolpace/path/path.h"
#include "toolpace/plan/motion_plan.h"

namespace toolpace {

/// The plan with a standing phase for each pause; everything after it is later by its duration.
/// @param positions  of the path; the plan rests at every node that has a pause
MotionPlan insert_pauses(MotionPlan plan, const std::vector<Path::Pause>& pauses, const NodePositions& positions);

}  // namespace toolpace
