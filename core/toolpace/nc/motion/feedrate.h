#pragma once
/// How fast a block's motion is commanded to be.

#include "toolpace/nc/context.h"

namespace toolpace::nc {

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

}  // namespace toolpace::nc
