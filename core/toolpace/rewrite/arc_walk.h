#pragma once
/// How far a chain of points is from an arc, a helix or a line that shall stand for it.

#include "toolpace/rewrite/flat.h"

namespace toolpace::detail::rewrite {

/// From start to end about a centre, along the normal evenly with the angle.
struct ArcShape {
  Flat start, end, centre;  ///< the centre's height counts for nothing
};

/// What was found along the way.
struct ArcWalk {
  bool goes_round = false;  ///< in one sense, by no chord farther than 30 degrees, which are sides of polygons
  bool fits = false;        ///< and within the tolerance
  bool clockwise = false;
  double sweep = 0.0;          ///< [rad] without sign
  double out = 0.0, in = 0.0;  ///< [mm] farthest outwards and inwards of the arc
  Flat out_at, in_at;          ///< where
};

/// Walks along the chain and the arc at the same angle about the centre, never going back. Distances of all pairs on the way, chords
/// between points included, are an upper bound of the Fréchet distance; it is exact but for what a radius that changes adds.
///
/// `tolerance` > 0 [mm]; `angles` is space to work in.
ArcWalk walk_arc(const FlatPoints& chain, const ArcShape& arc, double tolerance, std::vector<double>& angles);

/// The same along a straight line.
bool walk_line(const FlatPoints& chain, const Flat& start, const Flat& end, double tolerance);

}  // namespace toolpace::detail::rewrite
