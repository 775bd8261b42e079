#pragma once
/// The trapezoid law: constant acceleration.

#include <cmath>
#include <limits>

#include "toolpace/law/law.h"
#include "toolpace/law/ramp_phases.h"

namespace toolpace {

/// v rises with a constant acceleration A. Its jerk is UNBOUNDED: the acceleration steps at both ends of the ramp.
/// T = Δ/A; v1² = v0² + 2·A·L. Uses limits.acceleration alone; infinite = a step of the speed that takes no time.
/// @source the stepper text (docs/SOURCES.md); accuracy of reach 1e-15 relative
struct Trapezoid : LawBase<Trapezoid> {
  static constexpr LawKind kKind = LawKind::trapezoid;

  static double duration(double dv, const RampLimits& limits) { return dv / limits.acceleration; }

  static DurationTerms terms(const RampLimits& limits) { return {1 / limits.acceleration, 0.0, 0.0, 0.0, 0.0}; }

  static double reach(double v, double length, const RampLimits& limits) {
    if (std::isinf(limits.acceleration)) return limits.acceleration;
    return std::sqrt(v * v + 2 * limits.acceleration * length);
  }

  /// The jerk is infinite for every ramp that changes the speed.
  static RampPeaks peaks(double dv, double, const RampLimits& limits) {
    if (!(dv > 0)) return {};
    return {limits.acceleration, std::numeric_limits<double>::infinity()};
  }

  template <class Phases>
  static void write_ramp(const SpeedChange& ramp, const RampLimits& limits, Phases& phases) {
    detail::RampCursor cursor = detail::end_of(phases);
    const double acceleration = ramp.to > ramp.from ? limits.acceleration : -limits.acceleration;
    detail::append_piece({ramp.time, ramp.from, acceleration, 0.0}, cursor, phases);
  }
};

}  // namespace toolpace
