#pragma once
/// Corner curves: what replaces the node between two segments, with continuous curvature.

#include <array>
#include <cstdint>

#include "toolpace/path/curve_math.h"

namespace toolpace {

/// Between two lines: the cubic Bézier curve whose two inner control points are both the corner,
/// x(t) = corner − (1 − t)³·before + t³·after, 0 ≤ t ≤ 1. Its second derivative is along the lines at the ends, so curvature
/// grows from zero and falls back to zero; its third derivative is constant and small at sharp corners, where a motion slows
/// down into the curve and speeds up out of it. It misses the corner by |after − before| / 8.
struct CornerBlend {
  AxisVector corner;         ///< [mm, rad]
  AxisVector before, after;  ///< along the two lines, of equal length in X Y Z: how much of each is replaced
};

/// Between any two curves: a Bézier curve of degree 5, 0 ≤ t ≤ 1, with their positions, directions and curvatures at its ends.
struct CurveBlend {
  std::array<AxisVector, 6> points;
};

AxisVector blend_point(const CornerBlend& blend, double t);
AxisVector blend_point(const CurveBlend& blend, double t);
ParameterDerivatives blend_derivatives(const CornerBlend& blend, double t);
ParameterDerivatives blend_derivatives(const CurveBlend& blend, double t);

/// Length along X, Y, Z from the start to parameter t [mm]; relative accuracy 1e-9 for corners up to 165° and for curves that
/// turn as much.
double blend_length(const CornerBlend& blend, double t = 1);
double blend_length(const CurveBlend& blend, double t = 1);

/// Parameter at path length `s`; `length` = blend_length of the whole.
double blend_parameter(const CornerBlend& blend, double length, double s);
double blend_parameter(const CurveBlend& blend, double length, double s);

/// State of a curve where a blend joins it: by path length.
struct BlendEnd {
  AxisVector point, first, second;
};

/// Blend of about `length` mm between two ends.
CurveBlend make_curve_blend(const BlendEnd& begin, const BlendEnd& end, double length);

}  // namespace toolpace
