#pragma once
/// G5, G5.1: cubic and quadratic Bézier curves; G5.2 … G5.3: NURBS. All in the XY plane.

#include "toolpace/nc/context.h"

namespace toolpace::nc {

bool run_cubic_spline(Context& context, const Block& block);
bool run_quadratic_spline(Context& context, const Block& block);
bool collect_nurbs(Context& context, const Block& block);
bool finish_nurbs(Context& context, const Block& block);

}  // namespace toolpace::nc
