#pragma once
/// How the centripetal and the tangential part of a motion on a curve share the limits of the axes.

#include "toolpace/limits/machine.h"
#include "toolpace/path/path.h"

namespace toolpace {

/// Largest magnitudes, over a stretch of a segment, of an axis' first, second and third derivative by path length.
struct CurveBounds {
  AxisVector first, second, third;
};

/// Bounds over a whole segment. Exact for lines; for arcs the amplitude of each component (attained on any sweep of
/// half a turn or more, an over-estimate on shorter ones); for splines and blends samples, denser where a derivative may
/// rise between them, with what it may rise added: 6 % more than the largest at most. Where the parameter's speed vanishes
/// (cusps) the true bound is infinite; there the samples next to it count.
CurveBounds curve_bounds(const Path& path, std::size_t segment);

/// Constant path limits that keep every axis inside its own, anywhere on the segment:
///   |first|·a + |second|·v² ≤ acceleration,   |first|·j + 3·|second|·v·a + |third|·v³ ≤ jerk.
struct CurveBudget {
  double speed;         ///< [mm/s] cap from axis speed and curvature
  double acceleration;  ///< [mm/s²] left for the tangential part
  double jerk;          ///< [mm/s³]
  bool is_curvature;    ///< the cap comes from curvature, not from an axis' speed
};

/// @param speed_wanted  [mm/s] the feed: where the curve can be run at it, all that it leaves goes to the tangential
/// part
CurveBudget curve_budget(const CurveBounds& bounds, const std::array<AxisLimits, kAxisCount>& axes,
                         double speed_wanted);

}  // namespace toolpace
