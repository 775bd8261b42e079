#pragma once
/// The quintic law: a speed polynomial of fifth degree whose jerk is continuous and zero at both ends.

#include "toolpace/law/form_law.h"

namespace toolpace {

/// v = v0 + Δ·σ(t/T), σ(τ) = 10τ³ − 15τ⁴ + 6τ⁵, T = max(15Δ/(8A), √(10Δ/(√3·J))).
///
/// ERRATUM 1: eqs. (5)–(7) drop the jerk limit ("Jm ≫ Am"). That breaks it for every Δ < A²·(8/15)²·10/(√3·J): with the
/// paper's own A = 3000 mm/s², J = 10⁶ mm/s³ for every change of speed under 14.78 mm/s. Here eq. (4) is used whole.
/// ERRATUM 2: the deceleration case of eq. (7) has its sign turned; it is √(Vs² − 16/15·A·L).
/// @source Ning et al. 2014, eqs. (2)–(7)
struct Quintic : FormLaw<Quintic, QuinticForm> {
  static constexpr LawKind kKind = LawKind::quintic;
};

}  // namespace toolpace
