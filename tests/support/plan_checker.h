#pragma once
/// Checks a MotionPlan against its SpeedLimits on the exact polynomials, with none of the planner's own code.

#include <string>

#include "toolpace/limits/speed_limits.h"
#include "toolpace/plan/motion_plan.h"

namespace toolpace::test {

/// The worst use of each limit: 1 = exactly at the limit. Where a limit is infinite its use is 0.
struct PlanUse {
  double block_speed = 0;   ///< speed against block caps, over whole stretches
  double node_speed = 0;    ///< speed² against node caps² (rests: against what 1e-10 of the path's length allows)
  double acceleration = 0;  ///< against each block's own limit, speeding up or slowing down
  double jerk = 0;
  double speed_step = 0;         ///< largest jump of speed at a seam, relative to the top cap
  double acceleration_step = 0;  ///< largest jump of acceleration at a seam, relative to the limit there
  double position_step = 0;      ///< largest gap at a seam [mm]
  double time_step = 0;          ///< largest gap in time at a seam [s]
  double end_position = 0;       ///< distance of the end from the sum of the lengths [mm]
  double end_speed = 0;          ///< speed at the end [mm/s]
  double lowest_speed = 0;       ///< [mm/s]
  std::string where;             ///< the worst offence, for messages
};

PlanUse measure(const SpeedLimits& limits, const MotionPlan& plan);

struct CheckOptions {
  bool jerk = true;                     ///< false for the trapezoid
  bool continuous_acceleration = true;  ///< false for the trapezoid
  double tolerance = 1e-7;              ///< relative
};

/// Empty when the plan keeps everything, else what it breaks.
std::string find_offence(const SpeedLimits& limits, const MotionPlan& plan, const CheckOptions& options = {});

}  // namespace toolpace::test
