#pragma once
/// B-spline and NURBS curves with arc length, cut into pieces short enough for quadrature and for one speed cap each.

#include <Eigen/Core>
#include <vector>

#include "toolpace/nc/moves.h"
#include "toolpace/path/curve_math.h"

namespace toolpace {

/// A rational B-spline in homogeneous coordinates.
struct SplineCurve {
  int degree;
  std::vector<Eigen::Vector4d> points;  ///< (w·x, w·y, w·z, w)
  std::vector<double> knots;
  AxisVector rotary_begin, rotary_end;  ///< entries A, B, C: linear in the parameter
  bool is_polynomial = false;           ///< all weights are 1
};

/// Stretch [begin, end] of a spline's parameter.
struct SplinePiece {
  std::uint32_t spline;
  double begin, end;
};

SplineCurve make_spline(const AxisVector& begin, const AxisVector& end, const SplineDetail& detail);

/// Cuts a curve at its knots and further, until in each piece length is exact to 1e-13 relative and the curvature
/// changes by at most a third of its larger value. Bounded: at most 4096 pieces. Pieces without length are left out.
std::vector<SplinePiece> cut_spline(const SplineCurve& curve, std::uint32_t index);

/// Length of a stretch of the curve between two neighbouring knots [mm].
double piece_length(const SplineCurve& curve, double begin, double end);

/// Parameter at path length `s` from the piece's begin. `length` = piece_length of the piece.
double parameter_at(const SplineCurve& curve, const SplinePiece& piece, double length, double s);

/// Whether one piece follows the other inside a span or across a simple knot: then they meet with one derivative.
bool is_smooth_between(const SplineCurve& curve, const SplinePiece& before, const SplinePiece& after);

AxisVector spline_point(const SplineCurve& curve, double parameter);
ParameterDerivatives spline_derivatives(const SplineCurve& curve, double parameter);
/// Inside a piece or at its ends; at a knot those of the piece's side, where the other side's may be others.
ParameterDerivatives spline_derivatives(const SplineCurve& curve, const SplinePiece& piece, double parameter);

}  // namespace toolpace
