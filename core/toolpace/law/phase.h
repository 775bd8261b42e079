#pragma once
/// One polynomial piece of a motion along the path, and its exact evaluation.

#include <cstdint>

#include "toolpace/law/speed_form.h"

namespace toolpace {

/// Motion from a place on over `duration`. Whole profiles are sequences of phases that meet without gaps.
///
/// The place is a `distance` from a `node` of the path. It is the nearer the better: distances are rounded, and what an axis
/// makes of that may be many times a millimetre's rounding. Single moves count from their begin, as node 0.
struct Phase {
  double begin = 0.0;         ///< time at its start [s]
  double duration = 0.0;      ///< [s], ≥ 0
  double distance = 0.0;      ///< path length from the node to its start, negative before it [mm]
  double speed = 0.0;         ///< at its start [mm/s]
  double acceleration = 0.0;  ///< at its start [mm/s²]; 0 for forms
  double rate = 0.0;          ///< the jerk [mm/s³]; of forms the whole change of speed [mm/s]
  PhaseShape shape = PhaseShape::constant_jerk;
  std::uint32_t node = 0;  ///< of the path, near its start
};

struct PhaseState {
  double distance;      ///< from the phase's node; of a motion along a path, the position on it [mm]
  double speed;         ///< [mm/s]
  double acceleration;  ///< [mm/s²]
  double jerk;          ///< [mm/s³]
};

/// State `time` seconds after the phase's start, 0 ≤ time ≤ duration.
/// @source constant jerk: Zheng et al. 2014, eqs. (7)–(10)
inline PhaseState evaluate(const Phase& p, double time) {
  if (p.shape == PhaseShape::constant_jerk) {
    return {p.distance + time * (p.speed + time * (p.acceleration / 2 + time * p.rate / 6)),
            p.speed + time * (p.acceleration + time * p.rate / 2), p.acceleration + time * p.rate, p.rate};
  }
  if (p.duration <= 0) return {p.distance, p.speed, 0.0, 0.0};
  const double u = time / p.duration;
  return visit_form(p.shape, [&]<class Form>(Form) {
    return PhaseState{p.distance + time * (p.speed + Form::mean(p.rate, u)), p.speed + Form::value(p.rate, u),
                      Form::slope(p.rate / p.duration, u), Form::bend(p.rate / (p.duration * p.duration), u)};
  });
}

/// Exact extrema of speed, |acceleration| and |jerk| inside the phase (of the polynomial, not of samples).
struct PhaseExtrema {
  double min_speed, max_speed, max_acceleration, max_deceleration, max_jerk;  ///< magnitudes, ≥ 0 for the last three
};
PhaseExtrema extrema(const Phase& phase);

}  // namespace toolpace
