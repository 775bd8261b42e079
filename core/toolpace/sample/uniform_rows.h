#pragma once
/// Rows of setpoints that need not be looked at one by one.

#include <vector>

#include "toolpace/path/path.h"
#include "toolpace/plan/motion_plan.h"

namespace toolpace {

/// Rows first … end − 1, and some rows on both sides, lie within one phase of a plan at constant speed, or at rest, on one
/// straight segment: each axis moves by the same step from row to row.
struct UniformRows {
  std::size_t first, end;
};

/// The longer ones of a plan, in order: so many minutes at one feed cost nothing to measure.
///
/// @param period  [s] > 0
std::vector<UniformRows> uniform_rows(const Path& path, const MotionPlan& plan, double period);

}  // namespace toolpace
