#pragma once
/// How fast the spindle turns: G96 (constant surface speed) and G97.

#include "toolpace/nc/state.h"

namespace toolpace::nc {

/// Turns a minute of the spindle during a move from one X to another [mm from the axis of turning]. Under G96 they change
/// on the way; returned is the rate at which a feed per turn takes the time that the move really takes:
/// 1/n = the mean over the way of max(1/D, 2π|x|/S).
/// @return 0 where no speed is given; infinite under G96 without D where the move stays at X0
double spindle_turns(const State& state, double from, double to);

}  // namespace toolpace::nc
