#pragma once
/// Straight lines through two points of a chain.

#include <cstddef>

#include "toolpace/rewrite/curve.h"

namespace toolpace::detail::rewrite {

/// Whether the straight line between two vertices is within the tolerance of the chain between them, in order: a walk along
/// both that never goes back stays within it.
bool fits_line(const Curve& curve, std::size_t first, std::size_t last, double tolerance);

}  // namespace toolpace::detail::rewrite
