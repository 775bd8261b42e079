#pragma once
/// One polynomial piece of a motion along the path, and its exact evaluation.

#include <cstdint>

namespace toolpace {

enum class PhaseShape : std::uint8_t {
  constant_jerk,  ///< v(t) = speed + acceleration·t + rate·t²/2; rate is the jerk [mm/s³]; cruise and dwell have rate 0
  quintic  ///< v(t) = speed + rate·σ(t/duration), σ(τ) = 10τ³ − 15τ⁴ + 6τ⁵; rate is the whole speed change [mm/s]
};

/// Motion from `distance` on over `duration`. Whole profiles are sequences of phases that meet without gaps.
struct Phase {
  double begin = 0.0;         ///< time at its start [s]
  double duration = 0.0;      ///< [s], ≥ 0
  double distance = 0.0;      ///< path position at its start [mm]
  double speed = 0.0;         ///< at its start [mm/s]
  double acceleration = 0.0;  ///< at its start [mm/s²]; 0 for quintic
  double rate = 0.0;          ///< see PhaseShape
  PhaseShape shape = PhaseShape::constant_jerk;
};

struct PhaseState {
  double distance;      ///< [mm]
  double speed;         ///< [mm/s]
  double acceleration;  ///< [mm/s²]
  double jerk;          ///< [mm/s³]
};

/// State `time` seconds after the phase's start, 0 ≤ time ≤ duration.
/// @source constant jerk: Zheng et al. 2014, eqs. (7)–(10); quintic: Ning et al. 2014, eqs. (2), (3)
inline PhaseState evaluate(const Phase& p, double time) {
  if (p.shape == PhaseShape::constant_jerk) {
    return {p.distance + time * (p.speed + time * (p.acceleration / 2 + time * p.rate / 6)),
            p.speed + time * (p.acceleration + time * p.rate / 2), p.acceleration + time * p.rate, p.rate};
  }
  if (p.duration <= 0) return {p.distance, p.speed, 0.0, 0.0};
  const double u = time / p.duration;
  const double dv = p.rate;
  return {p.distance + time * (p.speed + dv * u * u * u * (2.5 + u * (-3 + u))),
          p.speed + dv * u * u * u * (10 + u * (-15 + 6 * u)), dv / p.duration * 30 * u * u * (1 - u) * (1 - u),
          dv / (p.duration * p.duration) * 60 * u * (1 - u) * (1 - 2 * u)};
}

/// Exact extrema of speed, |acceleration| and |jerk| inside the phase (of the polynomial, not of samples).
struct PhaseExtrema {
  double min_speed, max_speed, max_acceleration, max_deceleration, max_jerk;  ///< magnitudes, ≥ 0 for the last three
};
PhaseExtrema extrema(const Phase& phase);

}  // namespace toolpace
