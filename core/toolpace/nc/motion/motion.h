#pragma once
/// Which motion a motion code is, and G0 and G1 themselves.

#include "toolpace/nc/context.h"
#include "toolpace/nc/motion/end_point.h"
#include "toolpace/nc/motion/feedrate.h"

namespace toolpace::nc {

/// Goes straight to `end`, by G0 or G1, with cutter compensation where it is on.
bool go_straight(Context& context, const Block& block, Code code, const Position& end);

/// Runs the block's motion in the active motion mode `code`.
bool run_motion(Context& context, const Block& block, Code code);

}  // namespace toolpace::nc
