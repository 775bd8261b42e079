#pragma once
/// The tool's direction on the great circle between two directions, in rotary axes.

#include <optional>
#include <vector>

#include "toolpace/kinematics/rotary_turn.h"

namespace toolpace {

/// How near the tool stays to the great circle [rad]: 10 nm at the end of 100 mm.
inline constexpr double kInPlane = 1e-7;

/// A place on the way, with derivatives by the share of it.
struct SharePlace {
  double share;  ///< 0 … 1
  RotaryPlace place;
};

/// Places of the rotary axes from one stand to another one, the ends among them, between which polynomials of degree 5
/// (turn_between()) keep the tool within kInPlane of where it is while it turns evenly in the plane of both directions. Between two
/// places the rotary axes turn by at most 8.6 degrees in all. Axes that are none of the chain turn evenly.
///
/// Derivatives solve those of tool(α, β) = Rot(u, α)·Rot(w, β)·z for the angles. @source implicit differentiation
///
/// @param from, to  [rad] of A B C; X Y Z are not read
/// @return empty where the rotary axes may turn evenly. None where no way in the plane leads from the one to the other: the way on
/// which they go there steadily ends at other angles, the tool stands in a pole where the farther joint would have to turn, both
/// directions are opposite, or there are no two joints that turn the tool.
std::optional<std::vector<SharePlace>> turn_in_plane(const Chain& chain, const AxisVector& from, const AxisVector& to);

}  // namespace toolpace
