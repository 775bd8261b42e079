#pragma once
/// G2 and G3: circular, helical and (within tolerance) spiral motion.

#include "toolpace/nc/context.h"

namespace toolpace::nc {

/// An arc in its plane, in work coordinates.
struct PlaneArc {
  std::array<double, 2> start{}, end{}, centre{};
  int turns = 1;  ///< signed: + counter-clockwise; 1 = less than or exactly one turn
};

/// Sweep of an arc about its centre [rad], signed; an arc that ends where it starts is a full turn.
double sweep_of(const PlaneArc& arc);

bool run_arc(Context& context, const Block& block, Code code);

/// Goes around `arc` to `end`, with cutter compensation where it is on.
bool go_around(Context& context, const Block& block, const PlaneArc& arc, const Position& end);

/// Whether an arc's radii at its start and end are alike, as far as the dialect wants it, or --arc-tolerance-mm.
bool check_radii(Context& context, double at_start, double at_end, std::size_t column);

/// Appends the arc as a row; `end` gives the axes outside the plane.
void write_arc(Context& context, const PlaneArc& arc, const Position& from, const Position& end, double feed_mm_min);

}  // namespace toolpace::nc
