#pragma once
/// Straight motion: end points of blocks, feedrates, G0, G1, G33, G33.1 and probing.

#include <optional>

#include "toolpace/nc/context.h"

namespace toolpace::nc {

/// Where a block's axis words lead, in work coordinates: G90/G91, units, diameter mode, polar words and G53.
/// Starts from the programmed contour while cutter compensation is active.
bool find_end(Context& context, const Block& block, Position& end);

/// Where the program thinks the tool is: the contour while compensation is active, else the tool.
const Position& programmed_position(const State& state);

/// Whether the block gives this axis a value: by its letter, or in lathe programs by that of its increment.
bool names_axis(const Context& context, const Block& block, std::size_t axis);

/// A length word in mm.
double length_of(const State& state, const Block& block, char letter);

/// What a feedrate may depend on.
struct Way {
  double linear = 0.0;          ///< [mm] length along X Y Z
  double angular = 0.0;         ///< [deg], used where the former is 0
  double from = 0.0, to = 0.0;  ///< X [mm]: the radius, where the work turns
};

/// The feedrate of a block in the active feed mode.
bool find_feedrate(Context& context, const Block& block, const Way& way, Feedrate& feed);

/// The same for a straight move between two points.
bool find_straight_feedrate(Context& context, const Block& block, const Position& from, const Position& to,
                            Feedrate& feed);

/// Goes straight to `end`, by G0 or G1, with cutter compensation where it is on.
bool go_straight(Context& context, const Block& block, Code code, const Position& end);

/// Runs the block's motion in the active motion mode `code`.
bool run_motion(Context& context, const Block& block, Code code);

}  // namespace toolpace::nc
