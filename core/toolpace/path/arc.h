#pragma once
/// Circular, helical and spiral arcs, exact.

#include <Eigen/Core>

#include "toolpace/nc/moves.h"
#include "toolpace/path/curve_math.h"

namespace toolpace {

/// point(φ) = centre + r(φ)·(cos φ·radial + sin φ·lateral) + rise·(φ/sweep)·normal, 0 ≤ φ ≤ sweep, with r(φ) going
/// linearly from start_radius to end_radius. Rotary axes follow linearly in φ.
struct ArcCurve {
  Eigen::Vector3d centre;           ///< [mm], in the plane level of the start
  Eigen::Vector3d radial;           ///< unit vector from the centre to the start
  Eigen::Vector3d lateral;          ///< unit vector of the direction of turning at the start
  Eigen::Vector3d normal;           ///< unit vector, radial × lateral
  double start_radius, end_radius;  ///< [mm]
  double sweep;                     ///< [rad] > 0
  double rise;                      ///< [mm] along the normal
};

ArcCurve make_arc(const AxisVector& begin, const AxisVector& end, const ArcDetail& detail);

/// Length along X, Y, Z [mm], relative accuracy 1e-13 (closed form for circles and helices).
double arc_length(const ArcCurve& arc);

/// Angle at path length `s` [rad]; inverse of the length from the start. `length` = arc_length(arc).
double angle_at(const ArcCurve& arc, double length, double s);

/// Its part between two path lengths, 0 ≤ begin < end ≤ length.
ArcCurve part_of_arc(const ArcCurve& arc, double length, double begin, double end);

/// Point of the arc and derivatives by φ, X Y Z only (the other entries are zero).
AxisVector arc_point(const ArcCurve& arc, double angle);
ParameterDerivatives arc_derivatives(const ArcCurve& arc, double angle);

}  // namespace toolpace
