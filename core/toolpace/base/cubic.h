#pragma once
/// Closed-form roots of the cubics that jerk-limited ramps lead to.

#include <cmath>

namespace toolpace {

/// The one real root u ≥ 0 of u³ + p·u = q.
///
/// Cardano's u = α − β, α³ − β³ = q, α·β = p/3, written as q/(α² + αβ + β²) so that nothing cancels where p is large.
///
/// @param p  ≥ 0 @param q ≥ 0, both below about 1e100 so that cubes do not overflow
/// @return the root, relative error below 1e-14
inline double depressed_cubic_root(double p, double q) {
  if (!(q > 0)) return 0.0;
  const double third = p / 3;
  const double half = q / 2;
  const double alpha = std::cbrt(half + std::sqrt(half * half + third * third * third));
  const double beta = third / alpha;
  return q / (alpha * alpha + third + beta * beta);
}

}  // namespace toolpace
