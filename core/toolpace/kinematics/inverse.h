#pragma once
/// Tip and tool direction -> axes: both ways, their windings, and what happens at poles.

#include <array>
#include <limits>
#include <vector>

#include "toolpace/base/result.h"
#include "toolpace/kinematics/chain.h"

namespace toolpace {

/// What each rotary axis may be turned to [rad]; unbounded ends are infinite.
struct RotaryTravel {
  std::array<double, kAxisCount> low, high;

  static RotaryTravel unbounded();
  bool operator==(const RotaryTravel&) const = default;
};

/// The angles of the rotary axes that point the tool as asked: at most two ways. Of each the turns nearest to `near` that lie inside
/// the travel; the nearer way first (the larger of its turns the smaller), of two as near the one in which the joint next to the tool
/// stands at the larger angle.
///
/// Where a joint that is the farther one from the tool turns about the tool itself (the pole: C of an AC table with A = 0), every
/// angle of it points the tool as asked: it stays as it is in `near`. So does a joint that turns the tool about itself.
///
/// Two joints: with u and w their directions, the farther one from the tool and the nearer, the tool is Rot(u, α)·Rot(w, β)·z: the
/// vector between both turns lies on a cone about each joint. @source Paden 1986 (subproblem 2 of Paden and Kahan)
///
/// @param tool  direction from the tip to the spindle in the workpiece, of any length above 0
/// @return [mm, rad]; X Y Z as in `near`. Errors (infeasible): "tool-direction-unreachable", with how many degrees are missing;
/// "rotary-travel", where every way lies beyond the travel
Result<std::vector<AxisVector>> rotary_solutions(const Chain& chain, const Eigen::Vector3d& tool,
                                                 const AxisVector& near,
                                                 const RotaryTravel& travel = RotaryTravel::unbounded());

/// The axes that bring the tool into a pose, by the nearest way of rotary_solutions(), whose errors it has.
Result<AxisVector> inverse(const Chain& chain, const ToolPose& pose, const AxisVector& near,
                           const RotaryTravel& travel = RotaryTravel::unbounded());

}  // namespace toolpace
