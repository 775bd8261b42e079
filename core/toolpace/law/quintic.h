#pragma once
/// The quintic law: a speed polynomial of fifth degree whose jerk is continuous and zero at both ends.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "toolpace/base/cubic.h"
#include "toolpace/law/law.h"
#include "toolpace/law/ramp_phases.h"

namespace toolpace {

/// v = v0 + Δ·σ(t/T), σ(τ) = 10τ³ − 15τ⁴ + 6τ⁵, T = max(15Δ/(8A), √(10Δ/(√3·J))). Either limit may be infinite.
///
/// ERRATUM 1: eqs. (5)–(7) drop the jerk limit ("Jm ≫ Am"). That breaks it for every Δ < A²·(8/15)²·10/(√3·J): with the
/// paper's own A = 3000 mm/s², J = 10⁶ mm/s³ for every change of speed under 14.78 mm/s. Here eq. (4) is used whole:
/// reach() solves (2v+Δ)/2·T(Δ) = L, a quadratic in Δ where acceleration decides, a cubic in √Δ where jerk does.
/// ERRATUM 2: the deceleration case of eq. (7) has its sign turned; it is √(Vs² − 16/15·A·L).
/// @source Ning et al. 2014, eqs. (2)–(7). Reach 1e-14 relative.
struct Quintic : LawBase<Quintic> {
  static constexpr LawKind kKind = LawKind::quintic;
  static constexpr double kSteepest = 15.0 / 8;                        ///< largest σ′
  static constexpr double kSharpest = 10.0 * std::numbers::inv_sqrt3;  ///< largest |σ″|

  static double duration(double dv, const RampLimits& limits) {
    return std::max(kSteepest * dv / limits.acceleration, std::sqrt(kSharpest * dv / limits.jerk));
  }

  static DurationTerms terms(const RampLimits& limits) {
    return detail::larger_of(kSteepest, limits.acceleration, std::sqrt(kSharpest), limits.jerk);
  }

  static double reach(double v, double length, const RampLimits& limits) {
    // Both limits decide at once for Δ* = A²·(8/15)²·10/(√3·J), a ramp of T* = Δ*·15/(8A).
    const double slope = limits.acceleration / kSteepest;
    const double time = kSharpest * slope / limits.jerk;
    const double change = time * slope;
    if (!(length < (v + change / 2) * time)) {
      return std::isinf(slope) ? slope : std::sqrt(v * v + 2 * slope * length);
    }
    const double root = depressed_cubic_root(2 * v, 2 * length * std::sqrt(limits.jerk / kSharpest));
    return v + root * root;
  }

  static RampPeaks peaks(double dv, double time, const RampLimits&) {
    return detail::shape_peaks(kSteepest, kSharpest, dv, time);
  }

  template <class Phases>
  static void write_ramp(const SpeedChange& ramp, const RampLimits&, Phases& phases) {
    if (!(ramp.time > 0)) return;
    const detail::RampCursor cursor = detail::end_of(phases);
    phases.push_back(
        {cursor.begin, ramp.time, cursor.distance, ramp.from, 0.0, ramp.to - ramp.from, PhaseShape::quintic});
  }
};

}  // namespace toolpace
