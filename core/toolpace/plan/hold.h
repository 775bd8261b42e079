#pragma once
/// Feed hold: a stop on the path at any time, and the way on from there.

#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"
#include "toolpace/limits/speed_limits.h"
#include "toolpace/plan/motion_plan.h"
#include "toolpace/plan/options.h"

namespace toolpace {

/// When the operator presses hold, and for how long.
struct Hold {
  double time;         ///< [s] ≥ 0, from the plan's start, pauses included
  double pause = 1.0;  ///< rest before the motion goes on [s] ≥ 0
};

/// The plan with a feed hold in it.
///
/// From `time` on the motion brakes with the deceleration and jerk that the blocks under it allow, stays on the path and
/// below its caps, rests, and is planned anew from there to the end with the same options. Where the stop does not fit
/// under a cap just ahead (a valley that the plan is in already) it begins as soon as it does. A hold during a pause
/// makes the pause longer. Pauses behind the stop are kept.
///
/// @param plan  from rest to rest over the whole chain, pauses inserted
/// @return error infeasible "hold-after-end" with the cycle time as attainable value; errors of plan_motion()
Result<MotionPlan> insert_hold(const SpeedLimits& limits, const MotionPlan& plan, const PlanOptions& options,
                               const Hold& hold, const Monitor& monitor = {});

/// Usage error "hold-time" where it has a negative time.
Result<void> check_hold(const Hold& hold);

/// Infeasible "hold-after-end", with the cycle time as attainable value.
Error hold_after_end(const Hold& hold, double cycle_time);

}  // namespace toolpace
