#pragma once
/// The length of a spline while it is read: inverse-time feeds need it.

#include "toolpace/nc/moves.h"

namespace toolpace::nc {

/// Length of the curve [mm], to about 1e-6 relative on smooth curves: chords of two densities, extrapolated.
double length_of_spline(const SplineDetail& spline);

}  // namespace toolpace::nc
