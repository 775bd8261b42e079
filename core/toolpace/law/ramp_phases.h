#pragma once
/// How laws write their phases.

#include "toolpace/law/law.h"
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
void append_parabolas(const SpeedChange& ramp, Phases& phases) {
  if (!(ramp.time > 0)) return;
  RampCursor cursor = end_of(phases);
  const double half = ramp.time / 2;
  const double peak = (ramp.to - ramp.from) / half;  // signed: negative when slowing down
  const double jerk = peak / half;
  append_piece({half, ramp.from, 0.0, jerk}, cursor, phases);
  append_piece({half, ramp.from / 2 + ramp.to / 2, peak, -jerk}, cursor, phases);
}

}  // namespace toolpace::detail
