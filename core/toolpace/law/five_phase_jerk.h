#pragma once
/// The five-phase law by jerk: two parabolas a ramp, as fast as the jerk allows.

#include <algorithm>
#include <cmath>
#include <limits>

#include "toolpace/base/cubic.h"
#include "toolpace/law/law.h"
#include "toolpace/law/ramp_phases.h"

namespace toolpace {

namespace detail {

/// Speed that a ramp of two parabolas at jerk J reaches: (2v+Δ)·√(Δ/J) = L, a cubic in √Δ.
inline double jerk_reach(double v, double length, double jerk) {
  if (std::isinf(jerk)) return jerk;
  const double root = depressed_cubic_root(2 * v, length * std::sqrt(jerk));
  return v + root * root;
}

/// Speed that a ramp of two parabolas with peak acceleration A reaches: (2v+Δ)·Δ/A = L.
inline double parabola_reach(double v, double length, double acceleration) {
  if (std::isinf(acceleration)) return acceleration;
  return std::sqrt(v * v + acceleration * length);
}

}  // namespace detail

/// Jerk +J for the first half of the ramp, −J for the second; no phase of constant acceleration. Where that would pass
/// the acceleration limit the ramp is stretched: T = max(2·√(Δ/J), 2Δ/A). Either limit may be infinite.
/// @source Zheng et al. 2014, eqs. (7)–(10); the acceleration limit is added, Zheng has none. Reach 1e-14 relative.
struct FivePhaseJerk : LawBase<FivePhaseJerk> {
  static constexpr LawKind kKind = LawKind::five_phase_jerk;

  static double duration(double dv, const RampLimits& limits) {
    return 2 * std::max(std::sqrt(dv / limits.jerk), dv / limits.acceleration);
  }

  static DurationTerms terms(const RampLimits& limits) {
    return detail::larger_of(2.0, limits.acceleration, 2.0, limits.jerk);
  }

  static double reach(double v, double length, const RampLimits& limits) {
    if (std::isinf(limits.acceleration)) return detail::jerk_reach(v, length, limits.jerk);
    const double by_acceleration = detail::parabola_reach(v, length, limits.acceleration);
    // The jerk needs no look where even the ramp at full acceleration stays under it: 4Δ/T² = A²/Δ ≤ J.
    if ((by_acceleration - v) * limits.jerk >= limits.acceleration * limits.acceleration) return by_acceleration;
    return std::min(by_acceleration, detail::jerk_reach(v, length, limits.jerk));
  }

  static RampPeaks peaks(double dv, double time, const RampLimits&) { return detail::shape_peaks(2.0, 4.0, dv, time); }

  template <class Phases>
  static void write_ramp(const SpeedChange& ramp, const RampLimits&, Phases& phases) {
    detail::append_parabolas(ramp, phases);
  }
};

}  // namespace toolpace
