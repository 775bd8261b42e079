#pragma once
/// The one answer to "how much faster could this job be?": a time that no plan of it can beat.

#include "toolpace/pipeline/job.h"

namespace toolpace {

/// Lower bound of the cycle time of an outcome's job [s], pauses included: whatever law that keeps the job's jerk limit,
/// ramps, look-ahead and way of planning, on the same path with the same corner rule; for a job through the tolerance tube,
/// whatever motion inside it (tube_bound.h).
///
/// On a path, the outcome's own caps and ramp limits count on lines, where they are exact. On curves they are a choice of the
/// planner, which parts the axes' limits between turning and changing speed; there only what no motion can exceed counts
/// (open_limits()), and for laws that keep jerk the dual of the fastest timing (stretch_bound.h): within 3 % on arcs.
/// @return Errors: of build_path; cancelled
Result<double> lower_bound(const Outcome& outcome, const Monitor& monitor = {});

/// The limits of an outcome, on curves opened up to what any motion keeps. With ‖A‖, ‖J‖ the axes' limits together and κ the
/// curvature of a segment, an acceleration vector of axes within theirs has along and across the path
///   |s″| ≤ ‖A‖,   κ·s′² ≤ ‖A‖,   and a jerk vector |s‴ − κ²·s′³| ≤ ‖J‖, so |s‴| ≤ ‖J‖ + κ²·s′³.
SpeedLimits open_limits(const Outcome& outcome);

}  // namespace toolpace
