#pragma once
/// Where a planned motion is at any time.

#include <vector>

#include "toolpace/path/path.h"
#include "toolpace/plan/motion_plan.h"

namespace toolpace {

/// Positions on the exact geometry and the exact polynomials. Times near the last one asked for are fast, others are found by
/// walking there. Keeps references: path and plan must outlive it.
class MotionCursor {
 public:
  MotionCursor(const Path& path, const MotionPlan& plan);

  /// @param time  [s], held at the motion's ends
  /// @return [mm, rad]
  AxisVector at(double time);

 private:
  const Path& path_;
  const MotionPlan& plan_;
  std::vector<double> begin_;  ///< path position of each segment's start
  std::size_t phase_ = 0;
  std::size_t segment_ = 0;
  std::size_t spline_ = 0;
};

}  // namespace toolpace
