#pragma once
/// Limits as differences of control points, and the step of the time spline that suits them.

#include "toolpace/plan/smooth/plan_tube.h"
#include "toolpace/plan/smooth/tube_path.h"

namespace toolpace::detail::tube {

/// Limits of coordinate differences over one step h: speed·h, acceleration·h², jerk·h³.
struct StepLimits {
  double order[3][kAxisCount];  ///< of each coordinate of the path
  double norm[3];               ///< of the vector over the first `linear` coordinates
  int linear;                   ///< 1 … axes
  double step;                  ///< h [s]
  int samples;                  ///< tube stations an interval, so that they stand a period apart at most
  int aimed;                    ///< of these that the optimiser looks at, evenly spaced
  TubeEffort effort;
  int quick_rounds;  ///< of a quick effort, before it comes close to the limits
};

/// The same limits over steps `by` times as long.
StepLimits coarser(const StepLimits& limits, std::size_t by);

/// The step follows the time in which a corner of the tube's size is turned, as a whole number of periods or a whole
/// part of one.
StepLimits step_limits(const TubePath& path, const TubeLimits& limits, double period, TubeEffort effort);

}  // namespace toolpace::detail::tube
