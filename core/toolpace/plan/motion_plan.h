#pragma once
/// A planned motion along a path: phases in the order of time, without gaps, from rest to rest.

#include <cstdint>
#include <vector>

#include "toolpace/law/phase.h"
#include "toolpace/limits/speed_limits.h"
#include "toolpace/plan/time_spline.h"

namespace toolpace {

struct MotionPlan {
  std::vector<Phase> phases;  ///< dwells are phases at speed 0 that go nowhere
  /// Stretches that are run as a spline in time, off the path by up to the tolerance, in the order of time. The phases of
  /// such a stretch only sketch it, one a knot interval: the spline is what is run.
  std::vector<TimeSpline> splines;

  /// [s]
  double cycle_time() const { return phases.empty() ? 0.0 : phases.back().begin + phases.back().duration; }
};

/// Over which time which limit held the speed down. Consecutive, without gaps, over the whole plan.
struct Restraint {
  double begin;         ///< [s]
  double end;           ///< [s]
  std::uint32_t block;  ///< block under the tool when it began
  Cause cause;
};

}  // namespace toolpace
