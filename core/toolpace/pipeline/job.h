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
#include "toolpace/nc/reader.h"
#include "toolpace/path/blend_path.h"
#include "toolpace/path/commanded.h"
#include "toolpace/path/path.h"
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
  bool bound = false;  ///< compute the lower bound of the cycle time too
  bool refined =
      true;  ///< time rounded corners anew under the axes' own limits, which takes longer than the plan itself
};

struct Summary {
  std::size_t blocks = 0;
  double path_length = 0;                                                ///< [mm]
  double cycle_time = 0, feed_time = 0, rapid_time = 0, dwell_time = 0;  ///< [s]
  double max_speed = 0, max_acceleration = 0,
         max_jerk = 0;                                 ///< of the exact profile along the path; jerk may be infinite
  std::array<double, kCauseCount> time_by_cause = {};  ///< [s], indexed by Cause
  std::optional<double> bound;                         ///< [s]
  BlendCount blends;                                   ///< corners rounded on the path (CornerRule::blend, G64 P)
  // Of the motion through the tolerance tube (CornerRule::smooth):
  double tube_deviation = 0;       ///< largest distance from the programmed path at setpoints and vertices [mm, deg]
  std::size_t tube_windows = 0;    ///< optimised
  std::size_t tube_fallbacks = 0;  ///< of these, left with a stop because nothing faster passed every check
};

/// A planned program. Immutable; shared between threads.
struct Outcome {
  std::shared_ptr<const Job> job;
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
/// tube that do not pass every check, leave the latter with the warning "smooth-fell-back". Errors: of check_setup,
/// build_path, limit_speed, plan_motion; input (motion-too-long: more than 1e9 setpoints).
Result<Outcome> run(std::shared_ptr<const Job> job, const Monitor& monitor = {});

/// Does the job look for a faster motion after it has a good one, through the tube or on its rounded path? Then a person who
/// waits is better served with quick_version() first: corners blended inside the same tolerance, and not timed anew.
bool takes_long(const Job& job);
std::shared_ptr<const Job> quick_version(const Job& job);

}  // namespace toolpace
