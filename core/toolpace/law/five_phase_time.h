#pragma once
/// The five-phase law by time: every ramp lasts Tacc (Tdec), however small the change of speed.

#include <algorithm>
#include <cmath>
#include <limits>

#include "toolpace/law/five_phase_jerk.h"
#include "toolpace/law/law.h"
#include "toolpace/law/ramp_phases.h"

namespace toolpace {

/// Two parabolas a ramp, T = max(limits.time, 2Δ/A, 2·√(Δ/J)) for Δ > 0 and 0 for Δ = 0. Infinite A and J give Zheng's
/// own law, T = Tacc exactly; finite ones keep a look-ahead inside its limits.
///
/// The duration does not shrink with Δ, so a ramp of hardly any change still needs v·T of length: the speeds that a
/// length L allows from v are {v} ∪ [0 … 2L/T − v], not an interval, and reach() returns v itself where L < v·T.
/// @source Zheng et al. 2014, eqs. (12), (13). Reach 1e-14 relative.
struct FivePhaseTime : LawBase<FivePhaseTime> {
  static constexpr LawKind kKind = LawKind::five_phase_time;

  static double duration(double dv, const RampLimits& limits) {
    if (!(dv > 0)) return 0.0;
    return std::max({limits.time, 2 * dv / limits.acceleration, 2 * std::sqrt(dv / limits.jerk)});
  }

  static DurationTerms terms(const RampLimits& limits) {
    DurationTerms terms = detail::larger_of(2.0, limits.acceleration, 2.0, limits.jerk);
    terms.floor = limits.time;
    return terms;
  }

  static double reach(double v, double length, const RampLimits& limits) {
    double best = limits.time > 0 ? 2 * (length / limits.time) - v : std::numeric_limits<double>::infinity();
    if (!(best > v)) return v;
    // A limit that the ramp found so far keeps need not be solved for.
    if (limits.time * limits.acceleration < 2 * (best - v)) {
      best = std::min(best, detail::parabola_reach(v, length, limits.acceleration));
    }
    if (limits.time * limits.time * limits.jerk < 4 * (best - v)) {
      best = std::min(best, detail::jerk_reach(v, length, limits.jerk));
    }
    return best;
  }

  static RampPeaks peaks(double dv, double time, const RampLimits&) { return detail::shape_peaks(2.0, 4.0, dv, time); }

  template <class Phases>
  static void write_ramp(const SpeedChange& ramp, const RampLimits&, Phases& phases) {
    detail::append_parabolas(ramp, phases);
  }
};

}  // namespace toolpace
