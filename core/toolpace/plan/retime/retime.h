#pragma once
/// A plan made faster where curves let the axes do more than caps by the block say.

#include <optional>

#include "toolpace/base/monitor.h"
#include "toolpace/limits/machine.h"
#include "toolpace/limits/ramp_limits.h"
#include "toolpace/limits/speed_limits.h"
#include "toolpace/path/commanded.h"
#include "toolpace/plan/for_each.h"
#include "toolpace/plan/motion_plan.h"
#include "toolpace/plan/options.h"

namespace toolpace {

/// What a plan was made from.
struct RetimeTask {
  const Path& path;
  const Commands& commands;
  const Machine& machine;
  const SpeedLimits& limits;
  const PlanOptions& options;  ///< the law's: jerk counts where it keeps it, and five-phase-time's least durations
};

/// What limits motion along the path, whatever turns. Five-phase-time's ramps by a change of speed Δ have 2Δ/T and 4Δ/T² at
/// most: with the highest commanded speed as Δ these count, too.
/// @param top_speed  commanded anywhere [mm/s]
RampLimits ramps_timed_anew(const PlanOptions& options, double top_speed, const PathLimits& path);

/// Block caps and ramp limits of a curve share the axes' limits between turning and changing speed, once for all. Here each
/// stretch from rest to rest that has curves is timed anew under the axes' limits themselves (curve_axes.h): the same path,
/// another speed. Corners are crossed no faster than their caps. What would not become faster stays as it is.
/// Linear time; stretches may be timed at the same time, with the same result.
/// @param plan   of these limits, without pauses
/// @param start  from where the search begins: like `plan`, of these limits or others that keep the same ones of the axes
/// @return nothing where no stretch became faster, or when cancelled
std::optional<MotionPlan> retime(const RetimeTask& task, const MotionPlan& plan, const MotionPlan& start,
                                 const ForEach& for_each = for_each_in_turn, const Monitor& monitor = {});

}  // namespace toolpace
