#pragma once
/// The highest speed of a single move.

#include "toolpace/law/duration_terms.h"
#include "toolpace/limits/ramp_limits.h"

namespace toolpace {

/// A move along a straight stretch: how far, how fast at most, and the speeds at its ends.
struct MoveRequest {
  double length = 0.0;  ///< [mm], ≥ 0
  double feed = 0.0;    ///< [mm/s], > 0
  double start = 0.0;   ///< speed at the start [mm/s], 0 … feed
  double end = 0.0;     ///< speed at the end [mm/s], 0 … feed
};

/// A law under given limits, prepared for many moves.
struct MoveTerms {
  DurationTerms up, down;
};

template <class Law>
MoveTerms move_terms(const Dynamics& dynamics) {
  return {Law::terms(dynamics.up), Law::terms(dynamics.down)};
}

/// Largest v ≤ feed, v ≥ max(start, end), with d(start→v) + d(v→end) ≤ length; max(start, end) where only the one ramp
/// that is needed fits (five-phase by time has such a gap, see single_move.h).
///
/// Precondition: that one ramp does fit. Closed form where both ramps are limited by acceleration or by Tacc, or both
/// by jerk from equal end speeds; else at most 60 steps of Newton's method on a convex increasing function. Does not
/// allocate. Relative error below 1e-14.
double peak_speed(const MoveRequest& move, const MoveTerms& terms);

template <class Law>
double peak_speed(double start, double end, double feed, double length, const Dynamics& dynamics) {
  return peak_speed({length, feed, start, end}, move_terms<Law>(dynamics));
}

}  // namespace toolpace
