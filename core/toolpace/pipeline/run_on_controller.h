#pragma once
/// A program as a real controller runs it, as the outcome of a job.

#include "toolpace/controller/prediction.h"
#include "toolpace/pipeline/job.h"

namespace toolpace {

/// What a limit is among the causes of a plan.
Cause cause_of(TimeLimit limit);

/// What runs a program.
struct ControllerRun {
  std::shared_ptr<const Reading> program;  ///< in the controller's dialect (dialect_of())
  std::string program_name;
  ProgramText text;  ///< of the same program
  ControllerSettings settings;
  PredictOptions options;
};

/// A prediction and its motion.
struct ControllerOutcome {
  Prediction prediction;
  Outcome outcome;  ///< its machine is the controller's (controller_setup()), whose limits the motion need not keep
};

/// Runs a program on a controller's model, and lays what that does on the program's own path: arcs, where the controller runs
/// chords, with the times of these. Blocks that a controller drops, being shorter than a step, take no time. A speed that changes
/// from one block to the next without time is what the controller does at corners.
/// Time lost because blocks did not arrive counts as the look-ahead's.
/// Errors: of predict(), build_path() and limit_speed(); input (controller-blends): LinuxCNC runs two blocks at a time, which is no
/// motion along the path.
Result<ControllerOutcome> run_on_controller(const ControllerRun& run, const Monitor& monitor = {});

/// An axis that is driven beyond its own limit.
struct AxisExcess {
  std::size_t axis;
  enum class Of : std::uint8_t { speed, acceleration } of;
  double value, limit;  ///< [mm/s or mm/s², rad …]
  std::uint32_t line;   ///< where it is worst
  double time;          ///< [s] when the segment begins
};

/// Axes that a motion drives more than a hundredth beyond the limits of its job's machine inside a segment, each at its worst; the
/// largest multiple of a limit first. Steps of the speed at corners are not counted.
Result<std::vector<AxisExcess>> axes_over_limits(const Outcome& outcome, const Monitor& monitor = {});

}  // namespace toolpace
