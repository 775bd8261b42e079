#pragma once
/// The duration of a ramp, in the one form that all laws share.

#include <algorithm>
#include <cmath>

namespace toolpace {

/// T(Δ) = max(floor, Δ ≥ threshold ? slope·Δ + offset : root·√Δ) for Δ > 0, and 0 for Δ = 0.
///
/// A law's limits enter only here, so that solvers over T are written once and a caller with few distinct limits
/// prepares them once. T(Δ)·(v + Δ/2) is increasing in Δ, and convex in √Δ; peak_speed() relies on both.
struct DurationTerms {
  double slope = 0.0;      ///< acceleration decides [s²/mm]; 0 where it is unbounded
  double offset = 0.0;     ///< time to build the acceleration up and down [s]
  double root = 0.0;       ///< jerk decides [s·√(s/mm)]; 0 where it is unbounded
  double threshold = 0.0;  ///< change of speed from which acceleration decides [mm/s]; may be infinite
  double floor = 0.0;      ///< least duration of any ramp [s]

  double duration(double dv) const {
    if (!(dv > 0)) return 0.0;
    return std::max(floor, dv >= threshold ? slope * dv + offset : root * std::sqrt(dv));
  }
};

/// The largest acceleration and jerk of a ramp, magnitudes.
struct RampPeaks {
  double acceleration = 0.0;  ///< [mm/s²]
  double jerk = 0.0;          ///< [mm/s³]
};

namespace detail {

/// Peaks of a ramp whose shape has these steepest and sharpest points, σ′ and |σ″|, and lasts `time`.
inline RampPeaks shape_peaks(double steepest, double sharpest, double dv, double time) {
  if (!(dv > 0)) return {};
  const double rate = 1 / time;
  return {steepest * dv * rate, sharpest * dv * rate * rate};
}

/// Terms of a law with T = max(by_acceleration·Δ/A, by_jerk·√(Δ/J)); A or J or both may be infinite.
inline DurationTerms larger_of(double by_acceleration, double acceleration, double by_jerk, double jerk) {
  const double root = by_jerk / std::sqrt(jerk);
  const double balance = root * acceleration / by_acceleration;  // no number where A and J are both infinite
  return {by_acceleration / acceleration, 0.0, root, root > 0 ? balance * balance : 0.0, 0.0};
}

}  // namespace detail
}  // namespace toolpace
