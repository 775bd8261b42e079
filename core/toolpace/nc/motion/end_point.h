#pragma once
/// Where a block's words lead.

#include "toolpace/nc/context.h"

namespace toolpace::nc {

/// Where a block's axis words lead, in work coordinates: G90/G91, units, diameter mode, polar words, angles and G53.
/// Starts from the programmed contour while cutter compensation is active.
bool find_end(Context& context, const Block& block, Position& end);

/// ,A: a line at an angle to the plane's first axis ends where the axis that is given does. Leaves `end` as it is where
/// both axes or none are given.
bool find_end_on_line(Context& context, const Block& block, const Position& from, Position& end);

/// Adds U V W H of lathes, whatever G90 or G91 would say.
bool add_increments(Context& context, const Block& block, Position& end);

/// Where the program thinks the tool is: the contour while compensation is active, else the tool.
const Position& programmed_position(const State& state);

/// Whether the block gives this axis a value: by its letter, or in lathe programs by that of its increment.
bool names_axis(const Context& context, const Block& block, std::size_t axis);

/// A length word in mm.
double length_of(const State& state, const Block& block, char letter);

}  // namespace toolpace::nc
