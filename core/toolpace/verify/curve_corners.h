#pragma once
/// Corners between two smooth runs, either of which may be a curve, seen in the positions alone.

#include <optional>

#include "toolpace/base/axes.h"
#include "toolpace/verify/row_stream.h"

namespace toolpace {

/// A corner within a row interval.
struct CurveCorner {
  AxisVector arriving, leaving;  ///< change of the axes by length of path at the corner [1, rad/mm; rad/deg]
  AxisVector bend;               ///< by how much their curvature changes there, magnitudes [1/mm, rad/mm²]
  double before, after;          ///< way from the row before to the corner, and from there to the next row [mm; deg]
};

/// The corner in the row interval `local` (between rows local−1 and local) where the three chords before it, and the three
/// behind it, turn as evenly as a line or an arc does, and the interval leads along the one and the other; at a row it
/// belongs to the interval behind. None where the rows show anything else.
///
/// @param noise  [mm] rounding of a position
std::optional<CurveCorner> corner_between_curves(const RowStream& stream, std::size_t local, double noise);

}  // namespace toolpace
