#pragma once
/// Job -> Outcome: the one call that the command line and the workbench make.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"
#include "toolpace/limits/machine.h"
#include "toolpace/limits/speed_limits.h"
#include "toolpace/nc/reading.h"
#include "toolpace/path/blend_path.h"
#include "toolpace/path/commanded.h"
#include "toolpace/path/path.h"
#include "toolpace/pipeline/settings.h"
#include "toolpace/plan/motion_plan.h"
#include "toolpace/plan/options.h"
#include "toolpace/sample/setpoints.h"

namespace toolpace {

/// Everything that decides a plan. Immutable once submitted.
struct Job {
  std::string program_name;
  std::shared_ptr<const Reading> program;
  Machine machine;
  PlanOptions options;
  bool refined =
      true;  ///< time rounded corners anew under the axes' own limits, which takes longer than the plan itself
};

/// Largest magnitudes of the exact profile along the path; jerk may be infinite.
struct Peaks {
  double speed = 0, acceleration = 0, jerk = 0;
};

struct Summary {
  std::size_t blocks = 0;
  double path_length = 0;                                                ///< [mm]
  double cycle_time = 0, feed_time = 0, rapid_time = 0, dwell_time = 0;  ///< [s]
  Peaks peaks;                                                           ///< along the path where X, Y or Z move [mm]
  Peaks rotary_peaks;                                  ///< where rotary axes alone move [deg]; 0 where they never do
  std::array<double, kCauseCount> time_by_cause = {};  ///< [s], indexed by Cause
  BlendCount blends;                                   ///< corners rounded on the path (CornerRule::blend, G64 P)
  // Of the motion through the tolerance tube (CornerRule::smooth):
  double tube_deviation = 0;       ///< largest distance from the programmed path at setpoints and vertices [mm, deg]
  std::size_t tube_windows = 0;    ///< optimised
  std::size_t tube_fallbacks = 0;  ///< of these, left with a stop because nothing faster passed every check
};

/// A planned program. Immutable; shared between threads.
struct Outcome {
  std::shared_ptr<const Job> job;  ///< what was asked for
  PlanOptions ran;                 ///< what was really used: where a way of planning has rules of its own, those
  Settings ignored;                ///< settings of the job that change nothing here
  std::shared_ptr<const Path> path;
  std::shared_ptr<const Commands> commands;  ///< of the path
  SpeedLimits limits;
  MotionPlan plan;
  std::vector<double> node_time;      ///< [s] arrival at each node of the path
  std::vector<Restraint> restraints;  ///< which limit binds when
  Summary summary;
  Diagnostics warnings;  ///< travel and the like
};

/// Plans a job. Same job, same bytes, whatever the threads. With CornerRule::smooth the plan is the faster one of the motion
/// through the tube and, where its setpoints prove it, of blended corners; an axis that nothing bounds, and setpoints in the
/// tube that do not pass every check, leave the latter with the warning "smooth-fell-back", which
/// names the check, the place and the cost. Errors: of check_setup, build_path, limit_speed, plan_motion; input
/// (motion-too-long: more than 1e9 setpoints).
Result<Outcome> run(std::shared_ptr<const Job> job, const Monitor& monitor = {});

}  // namespace toolpace
