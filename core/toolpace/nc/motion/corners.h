#pragma once
/// ,C and ,R at the end of a move: chamfers and roundings between it and the next one. ,A alone: it ends where the next
/// line meets it.

#include "toolpace/nc/context.h"
#include "toolpace/nc/motion/arcs.h"

namespace toolpace::nc {

/// Whether a move has to do with a corner: it ends in one, or the move before does.
inline bool meets_corner(const Context& context, const Block& block) {
  return context.state.waiting.has_value() || block.has_any(kCornerBits | kLineAngleBit);
}

/// Whether a straight move has words by which lathes mean corners and angles.
inline bool may_mean_corner(const Block& block) {
  return block.has_any(word_bit('a') | word_bit('c') | word_bit('r') | word_bit('i') | word_bit('k'));
}

/// The same straight move of a lathe with ,A ,C ,R in place of the words by which it means them: A, C, R, and I or K
/// beside the other axis.
Block with_corner_words(Context& context, const Block& block, Code motion);

/// Goes straight to `end` with the corners before and behind.
bool run_cornered_line(Context& context, const Block& block, Code code, const Position& end);
/// The same around an arc.
bool run_cornered_arc(Context& context, const Block& block, const PlaneArc& arc, const Position& end);

/// Runs the move that waits, if any, as it is: no move follows that could make a corner with it.
bool release_corner(Context& context);

}  // namespace toolpace::nc
