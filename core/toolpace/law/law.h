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

/// A law is a type with these static functions. `dv` ≥ 0, speeds ≥ 0, lengths ≥ 0; `limits` of the ramp's own
/// direction.
///   duration(dv, limits)       [s] least duration of a ramp by dv
///   reach(v, length, limits)   [mm/s] ≥ v: the largest speed that a ramp from v can end at (or, by symmetry, that can
///   be
///                              slowed to v) within `length`; v itself where no ramp fits
///   terms(limits)              the same duration in the form that all laws share
///   append_ramp(v0, v1, limits, phases)   appends the ramp's phases; the first one starts where the last phase of
///                              `phases` ends (begin, distance), or at 0. `phases` is a std::vector<Phase> or PhaseList
template <class Law>
concept VelocityLaw = requires(double x, const RampLimits& limits, std::vector<Phase>& phases) {
  { Law::kKind } -> std::convertible_to<LawKind>;
  { Law::duration(x, limits) } -> std::same_as<double>;
  { Law::reach(x, x, limits) } -> std::same_as<double>;
  { Law::terms(limits) } -> std::same_as<DurationTerms>;
  { Law::peak_acceleration(x, limits) } -> std::same_as<double>;
  { Law::peak_jerk(x, limits) } -> std::same_as<double>;
  Law::append_ramp(x, x, limits, phases);
};

/// Length of the ramp between two speeds [mm].
template <class Law>
double ramp_length(double v0, double v1, const RampLimits& limits) {
  return (v0 + v1) / 2 * Law::duration(v1 > v0 ? v1 - v0 : v0 - v1, limits);
}

}  // namespace toolpace
