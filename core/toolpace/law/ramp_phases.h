#pragma once
/// How laws write their phases.

#include "toolpace/law/phase.h"

namespace toolpace::detail {

/// Time and path position at which the next phase starts.
struct RampCursor {
  double begin = 0.0;
  double distance = 0.0;
};

template <class Phases>
RampCursor end_of(const Phases& phases) {
  if (phases.empty()) return {};
  const Phase& last = phases.back();
  return {last.begin + last.duration, evaluate(last, last.duration).distance};
}

/// A piece of constant jerk. Pieces without duration are left out: a phase that vanished is not in the profile.
struct JerkPiece {
  double duration, speed, acceleration, jerk;
};

template <class Phases>
void append_piece(const JerkPiece& piece, RampCursor& cursor, Phases& phases) {
  if (!(piece.duration > 0)) return;
  const Phase p{cursor.begin,       piece.duration, cursor.distance,          piece.speed,
                piece.acceleration, piece.jerk,     PhaseShape::constant_jerk};
  cursor = {p.begin + p.duration, evaluate(p, p.duration).distance};
  phases.push_back(p);
}

/// The ramp of two parabolas: jerk 4Δ/T² for the first half, −4Δ/T² for the second.
/// @source Zheng et al. 2014, eqs. (7)–(10), (12), (13)
template <class Phases>
void append_parabolas(double v0, double v1, double duration, Phases& phases) {
  if (!(duration > 0)) return;
  RampCursor cursor = end_of(phases);
  const double half = duration / 2;
  const double peak = (v1 - v0) / half;  // signed: negative when slowing down
  const double jerk = peak / half;
  append_piece({half, v0, 0.0, jerk}, cursor, phases);
  append_piece({half, v0 / 2 + v1 / 2, peak, -jerk}, cursor, phases);
}

}  // namespace toolpace::detail
