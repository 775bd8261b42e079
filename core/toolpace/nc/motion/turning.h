#pragma once
/// Single passes of Fanuc's lathes: G90 (turn), G94 (face), G92 (thread), and threads along a line, G32.

#include "toolpace/nc/context.h"

namespace toolpace::nc {

/// Runs G90, G92 or G94 of a block: to the work, along it, off it, and back to where it began.
bool run_turning(Context& context, const Block& block, Code code);

/// Cuts straight to `to` at the lead F or E, counted along the axis that goes further. Where a pull-out is set, the end
/// of the cut leaves the work at 45 degrees towards `away` (along X; its size is the most).
bool cut_lathe_thread(Context& context, const Block& block, const Position& to, double away);

/// G32: a straight move at F a turn.
bool run_lathe_thread(Context& context, const Block& block);

}  // namespace toolpace::nc
