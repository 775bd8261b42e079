#pragma once
/// Planning a whole program through the tolerance tube (--corner smooth).

#include "toolpace/limits/machine.h"
#include "toolpace/path/commanded.h"
#include "toolpace/plan/motion_plan.h"
#include "toolpace/plan/options.h"
#include "toolpace/plan/smooth/plan_tube.h"

namespace toolpace {

struct SmoothPlan {
  MotionPlan plan;
  std::vector<double> node_time;           ///< arrival at each node of the path [s]
  double deviation = 0;                    ///< largest distance from the polyline of the path [mm, deg]
  std::size_t windows = 0, fallbacks = 0;  ///< see TubeMotion
  bool took_lowest = false;                ///< of several limits that the program sets within one motion
};

/// Runs of blocks that have a tolerance become one motion each, through the tube; blocks without (G61, G61.1), and the
/// stops at pauses, stay exactly on the path, planned by the law of the options. A motion through the tube keeps one set of
/// limits: where the program changes them on its way, the lowest.
/// A feed hold of the options (hold_at, pauses of the path included) is in the plan: a pause becomes longer, exact blocks hold
/// as insert_hold() says, a motion through the tube as plan_tube().
/// @param limits  of the same path; the corner rule in them counts for the exact blocks alone
/// @return Errors: of plan_tube, plan_motion and insert_hold
Result<SmoothPlan> plan_smooth(const Path& path, const Commands& commands, const Machine& machine,
                               const SpeedLimits& limits, const PlanOptions& options,
                               const ForEach& for_each = for_each_in_turn, const Monitor& monitor = {},
                               TubeEffort effort = TubeEffort::thorough);

}  // namespace toolpace
