#pragma once
/// How much a segment of a path turns: what its axes must do when it is run.

#include "toolpace/path/path.h"

namespace toolpace {

/// Largest magnitudes, over a stretch of a segment, of an axis' first, second and third derivative by path length.
struct CurveBounds {
  AxisVector first = AxisVector::Zero(), second = AxisVector::Zero(), third = AxisVector::Zero();
  /// Of X, Y, Z: share of an axis in a vector in the osculating plane. The direction and the normal are at right angles, so
  /// t·(along the path) and n·(across it) give an axis no more than together·√(t² + n²).
  AxisVector together = AxisVector::Ones();
  double curvature = 0;  ///< [1/mm], at most
  double bend = 0;       ///< [1/mm²] of arcs: the third derivative is −bend·(the direction's part in their plane)
};

/// Bounds over a whole segment. Exact for lines, circles and helices; for spirals those of the ends; for splines and blends
/// samples, denser where a derivative may rise between them, with what it may rise added: 6 % more than the largest at most.
/// Where the parameter's speed vanishes (cusps) the true bound is infinite; there the samples next to it count.
CurveBounds curve_bounds(const Path& path, std::size_t segment);

}  // namespace toolpace
