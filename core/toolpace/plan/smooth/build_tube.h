#pragma once
/// From exact geometry to the polyline that the tube planner works on.

#include "toolpace/limits/machine.h"
#include "toolpace/path/commanded.h"
#include "toolpace/plan/smooth/tube_path.h"

namespace toolpace {

/// Segments begin … end − 1 of a path as a polyline. Curves become chords and nearly straight runs of short segments one;
/// what that costs, at most 4 % of the tolerance, comes off the tube. The ends are exact.
/// @pre the segments are either all rotary only or none of them is
TubePath build_tube(const Path& path, const Commands& commands, std::size_t begin, std::size_t end);

/// The machine's limits as the tube planner counts them (degrees).
TubeLimits tube_limits(const Machine& machine);

}  // namespace toolpace
