#pragma once
/// Velocity laws: what a law is, and the list of them.
///
/// A ramp changes the speed from v0 to v1 with zero acceleration at both ends and is point-symmetric about its middle,
/// so its distance is its mean speed times its duration: d = (v0+v1)/2 · T(|v1−v0|). A law is its duration T, its shape
/// as polynomial phases, and the inverse reach(v0, L). Everything else is generic over laws.

#include <concepts>
#include <cstdint>
#include <string_view>
#include <vector>

#include "toolpace/law/duration_terms.h"
#include "toolpace/law/phase.h"
#include "toolpace/limits/ramp_limits.h"

namespace toolpace {

enum class LawKind : std::uint8_t { trapezoid, five_phase_time, five_phase_jerk, seven_phase, quintic, time_optimal };

/// A ramp whose duration is known.
struct SpeedChange {
  double from;  ///< [mm/s]
  double to;    ///< [mm/s]
  double time;  ///< [s]
};

/// A law is a type with these static functions, and inherits LawBase.
/// dv ≥ 0, speeds ≥ 0, lengths ≥ 0; `limits` are those of the ramp's own direction.
///   duration(dv, limits)      [s] least duration of a ramp by dv
///   reach(v, length, limits)  [mm/s] ≥ v: the largest speed that a ramp from v can end at (or, by symmetry, that can be
///                             slowed to v) within `length`; v itself where no ramp fits
///   terms(limits)             the same duration in the form that all laws share
///   peaks(dv, time, limits)   the largest acceleration and jerk of a ramp that lasts `time` = duration(dv, limits)
///   write_ramp(ramp, limits, phases)  appends the ramp's phases; the first one starts where the last phase of `phases`
///                             ends (begin, distance), or at 0. `phases` is a std::vector<Phase> or a PhaseList
template <class Law>
concept VelocityLaw = requires(double x, const RampLimits& limits, const SpeedChange& ramp,
                               std::vector<Phase>& phases) {
  { Law::kKind } -> std::convertible_to<LawKind>;
  { Law::duration(x, limits) } -> std::same_as<double>;
  { Law::reach(x, x, limits) } -> std::same_as<double>;
  { Law::terms(limits) } -> std::same_as<DurationTerms>;
  { Law::peaks(x, x, limits) } -> std::same_as<RampPeaks>;
  Law::write_ramp(ramp, limits, phases);
};

/// What follows for every law.
template <class Law>
struct LawBase {
  /// Appends the phases of the ramp from v0 to v1 as write_ramp() does; none where v0 = v1.
  template <class Phases>
  static void append_ramp(double v0, double v1, const RampLimits& limits, Phases& phases) {
    Law::write_ramp({v0, v1, Law::duration(v1 > v0 ? v1 - v0 : v0 - v1, limits)}, limits, phases);
  }

  static double peak_acceleration(double dv, const RampLimits& limits) {
    return Law::peaks(dv, Law::duration(dv, limits), limits).acceleration;
  }

  static double peak_jerk(double dv, const RampLimits& limits) {
    return Law::peaks(dv, Law::duration(dv, limits), limits).jerk;
  }
};

/// Length of the ramp between two speeds [mm].
template <class Law>
double ramp_length(double v0, double v1, const RampLimits& limits) {
  return (v0 + v1) / 2 * Law::duration(v1 > v0 ? v1 - v0 : v0 - v1, limits);
}

}  // namespace toolpace
