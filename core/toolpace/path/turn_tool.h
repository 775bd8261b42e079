#pragma once
/// The tool turned in planes, where a program is so told.

#include "toolpace/path/path.h"

namespace toolpace {

/// The same path, on whose lines and arcs about the tip of a chain with Orientation::plane the tool turns evenly in the plane of the
/// directions at both ends of a block, within kInPlane. Such a segment is cut into pieces with a RotaryTurn each, which meet with two
/// derivatives. Where only the tool turns, lengths are degrees of the rotary axes along their curve.
///
/// Where no way in the plane leads to the programmed angles (turn_in_plane()), and on splines, the rotary axes turn evenly;
/// Path::out_of_plane tells the rows. A path without such a chain stays as it is.
/// @pre no handovers
Path turn_tool(Path path);

/// A warning "out-of-plane" for the first of those rows, with how many there are.
Diagnostics check_planes(const Path& path, const Moves& moves);

}  // namespace toolpace
