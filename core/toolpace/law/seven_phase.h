#pragma once
/// The seven-phase law: the fastest ramp under an acceleration and a jerk limit (S-curve).

#include <cmath>
#include <limits>

#include "toolpace/law/five_phase_jerk.h"
#include "toolpace/law/law.h"
#include "toolpace/law/ramp_phases.h"

namespace toolpace {

/// Jerk +J, constant acceleration A, jerk −J; the middle part vanishes for Δ < A²/J.
/// T = Δ/A + A/J if Δ ≥ A²/J, else 2·√(Δ/J). Infinite J makes it the trapezoid, infinite A the five-phase law by jerk.
///
/// The text's t1 = a/J, t2 = v/a − a/J hold only where every phase exists and both ends stand still; this is the
/// general case.
/// @source the seven-phase text (docs/SOURCES.md). Reach 1e-14 relative.
struct SevenPhase : LawBase<SevenPhase> {
  static constexpr LawKind kKind = LawKind::seven_phase;

  static double duration(double dv, const RampLimits& limits) {
    const double build_up = limits.acceleration / limits.jerk;
    // Both infinite: build_up is no number, the comparison fails and the second line gives 0.
    if (dv >= limits.acceleration * build_up) return dv / limits.acceleration + build_up;
    return 2 * std::sqrt(dv / limits.jerk);
  }

  static DurationTerms terms(const RampLimits& limits) {
    const double root = 2 / std::sqrt(limits.jerk);
    if (std::isinf(limits.acceleration)) return {0.0, 0.0, root, limits.acceleration, 0.0};
    const double build_up = limits.acceleration / limits.jerk;
    return {1 / limits.acceleration, build_up, root, limits.acceleration * build_up, 0.0};
  }

  static double reach(double v, double length, const RampLimits& limits) {
    const double build_up = limits.acceleration / limits.jerk;
    const double change = limits.acceleration * build_up;
    // Shortest length with a constant part: Δ = A²/J in 2·A/J.
    if (length >= (2 * v + change) * build_up) {
      const double lag = v - change / 2;
      return std::sqrt(lag * lag + 2 * limits.acceleration * length) - change / 2;
    }
    return detail::jerk_reach(v, length, limits.jerk);
  }

  static RampPeaks peaks(double dv, double time, const RampLimits& limits) {
    if (!(dv > 0)) return {};
    return {std::fmin(limits.acceleration, 2 * dv / time), limits.jerk};
  }

  template <class Phases>
  static void write_ramp(const SpeedChange& ramp, const RampLimits& limits, Phases& phases) {
    const double dv = std::abs(ramp.to - ramp.from);
    const double build_up = limits.acceleration / limits.jerk;
    if (!(dv >= limits.acceleration * build_up)) return detail::append_parabolas(ramp, phases);
    const double sign = ramp.to > ramp.from ? 1.0 : -1.0;
    const double jerk = build_up > 0 ? sign * limits.jerk : 0.0;
    const double acceleration = sign * limits.acceleration;
    const double rounding = acceleration * build_up / 2;  // speed gained while the acceleration builds up
    detail::RampCursor cursor = detail::end_of(phases);
    detail::append_piece({build_up, ramp.from, 0.0, jerk}, cursor, phases);
    detail::append_piece({ramp.time - 2 * build_up, ramp.from + rounding, acceleration, 0.0}, cursor, phases);
    detail::append_piece({build_up, ramp.to - rounding, acceleration, -jerk}, cursor, phases);
  }
};

/// Time-optimal planning under acceleration and jerk. A ramp between two speeds with zero acceleration at both ends is
/// fastest as a seven-phase ramp, so for single moves and block ramps this is that law; a planner whose ramps span
/// blocks does better by crossing nodes with acceleration.
struct TimeOptimal : SevenPhase {
  static constexpr LawKind kKind = LawKind::time_optimal;
};

}  // namespace toolpace
