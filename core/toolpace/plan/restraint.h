#pragma once
/// Why is it slow here: which limit holds the speed down, at every instant of a plan.

#include <array>
#include <vector>

#include "toolpace/limits/speed_limits.h"
#include "toolpace/plan/motion_plan.h"
#include "toolpace/plan/options.h"

namespace toolpace {

/// Restraints over the whole plan, consecutive and without gaps; neighbours differ in their cause.
///
/// - Cruising at a block's top speed: what set that speed (feed, rapid, axis speed, curvature, …).
/// - The valley around a slow place, where the curve of speed bends upwards: what set the cap that is touched in it
///   (corner, curvature, stop), or the feed of the slower block; look-ahead where no cap is touched and the window is short.
/// - Constant acceleration, and ramps that the acceleration stretches: acceleration or axis acceleration.
/// - The rest, above all where the curve bends down again towards its peak: jerk.
/// - Pauses: dwell.
///
/// @param node_time  arrival at each node in the same plan, pauses included (node_times() and Outcome::node_time)
std::vector<Restraint> explain(const SpeedLimits& limits, const MotionPlan& plan, const std::vector<double>& node_time,
                               const PlanOptions& options);

/// The one at a time; null before the first and where there is none. From a seam on it is the later one.
const Restraint* restraint_at(const std::vector<Restraint>& restraints, double time);

/// Time under each cause [s], indexed by Cause; sums up to the cycle time.
std::array<double, kCauseCount> time_by_cause(const std::vector<Restraint>& restraints);

}  // namespace toolpace
