#pragma once
/// ,C and ,R at the end of a move: chamfers and roundings between it and the next one.

#include "toolpace/nc/context.h"
#include "toolpace/nc/motion/arcs.h"

namespace toolpace::nc {

/// Whether a move has to do with a corner: it ends in one, or the move before does.
inline bool meets_corner(const Context& context, const Block& block) {
  return context.state.waiting.has_value() || block.has_any(kCornerBits) ||
         (context.rules.lathe_words && block.has('r') && block.code(GGroup::motion) != 20 &&
          block.code(GGroup::motion) != 30 && context.state.modal.motion == 10);
}

/// Goes straight to `end` with the corners before and behind.
bool run_cornered_line(Context& context, const Block& block, Code code, const Position& end);
/// The same around an arc.
bool run_cornered_arc(Context& context, const Block& block, const PlaneArc& arc, const Position& end);

/// Runs the move that waits, if any, as it is: no move follows that could make a corner with it.
bool release_corner(Context& context);

}  // namespace toolpace::nc
