#pragma once
/// The exact motion at any instant of a plan, wherever it is: in phases along the path, or in a spline off it.

#include <Eigen/Core>
#include <optional>

#include "toolpace/law/phase_bounds.h"
#include "toolpace/pipeline/job.h"

namespace toolpace::ui {

/// Index of the phase at a time, clamped to the plan. Precondition: there is one.
std::size_t phase_at(const MotionPlan& plan, double time);

/// Index of the block at a time, clamped to the path. Precondition: node_time is complete.
std::size_t block_at(const Outcome& outcome, double time);

/// The spline that is run at a time; null where the phases are.
const TimeSpline* spline_at(const MotionPlan& plan, double time);

/// State along the path, the time clamped to the plan. Precondition: there is a phase.
PhaseState motion_at(const MotionPlan& plan, double time);

/// Least and greatest values within a phase, between two times of the plan. Exact for phases; for the splines, whose
/// phases only sketch them, of eleven instants.
PhaseBounds motion_bounds(const MotionPlan& plan, std::size_t phase, double begin, double end);
PhaseBounds motion_bounds(const MotionPlan& plan, std::size_t phase);

/// Speed, acceleration and jerk of one axis inside a spline [mm, rad based].
struct AxisMotion {
  double speed, acceleration, jerk;
};
AxisMotion axis_motion(const TimeSpline& spline, double time, std::size_t axis);

}  // namespace toolpace::ui
