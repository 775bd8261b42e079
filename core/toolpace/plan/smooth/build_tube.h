#pragma once
/// From exact geometry to the polyline that the tube planner works on.

#include "toolpace/limits/machine.h"
#include "toolpace/nc/moves.h"
#include "toolpace/path/path.h"
#include "toolpace/plan/smooth/tube_path.h"

namespace toolpace {

struct TubeOptions {
  double tolerance = 0.01;      ///< [mm, deg] where the program says nothing else
  double feed_override = 1.0;   ///< on feed moves
  double rapid_override = 1.0;  ///< on rapids
};

/// Segments begin … end − 1 of a path as a polyline. Curves become chords and nearly straight runs of short segments one;
/// what that costs, at most 4 % of the tolerance, comes off the tube. The ends are exact.
/// @pre the segments are either all rotary only or none of them is
TubePath build_tube(const Path& path, const Moves& moves, const Machine& machine, const TubeOptions& options,
                    std::size_t begin, std::size_t end);

/// The machine's limits as the tube planner counts them (degrees).
TubeLimits tube_limits(const Machine& machine);

}  // namespace toolpace
