#pragma once
/// Runs of nearly straight short lines made one.

#include "toolpace/nc/moves.h"
#include "toolpace/path/blend_path.h"

namespace toolpace {

struct MergedLines {
  Path path;
  std::vector<double> error;  ///< of each segment: largest distance of the vertices that it leaves out [mm, deg]
};

/// Lines of one feed and mode without a pause between them become one while every vertex left out stays within a third of
/// the tolerance, in order, and the run turns by less than 20°. Everything else is copied.
MergedLines merge_lines(const Path& path, const Moves& moves, const Rounding& options);

}  // namespace toolpace
