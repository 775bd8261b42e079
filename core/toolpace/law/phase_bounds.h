#pragma once
/// Least and greatest speed, acceleration and jerk inside a phase, exact and with sign.

#include <algorithm>
#include <limits>

#include "toolpace/law/phase.h"

namespace toolpace {

struct Interval {
  double low, high;

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void add(const Interval& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
};

struct PhaseBounds {
  Interval speed;         ///< [mm/s]
  Interval acceleration;  ///< [mm/s²]
  Interval jerk;          ///< [mm/s³]

  /// Of no instant yet: low above high.
  static PhaseBounds nothing() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    constexpr Interval kNone{kInfinity, -kInfinity};
    return {kNone, kNone, kNone};
  }
  bool is_empty() const { return speed.low > speed.high; }

  void add(const PhaseBounds& other) {
    speed.add(other.speed);
    acceleration.add(other.acceleration);
    jerk.add(other.jerk);
  }
  void add(const PhaseState& state) {
    speed.add(state.speed);
    acceleration.add(state.acceleration);
    jerk.add(state.jerk);
  }

  /// Of what is in proportion to it.
  PhaseBounds scaled(double factor) const {
    const auto of = [factor](const Interval& i) {
      return Interval{std::min(factor * i.low, factor * i.high), std::max(factor * i.low, factor * i.high)};
    };
    return {of(speed), of(acceleration), of(jerk)};
  }
};

/// Bounds over the stretch from `from` to `to` seconds after the phase's start, 0 ≤ from ≤ to ≤ duration.
/// Forms: acceleration peaks in the middle, jerk at two places. Constant jerk: ends, and the speed's vertex where the
/// acceleration is 0.
inline PhaseBounds bounds(const Phase& p, double from, double to) {
  const PhaseState a = evaluate(p, from), b = evaluate(p, to);
  PhaseBounds box{{std::min(a.speed, b.speed), std::max(a.speed, b.speed)},
                  {std::min(a.acceleration, b.acceleration), std::max(a.acceleration, b.acceleration)},
                  {std::min(a.jerk, b.jerk), std::max(a.jerk, b.jerk)}};
  const auto inside = [&](double time) { return time > from && time < to; };
  if (p.shape != PhaseShape::constant_jerk) {
    if (inside(p.duration / 2)) box.acceleration.add(evaluate(p, p.duration / 2).acceleration);
    const double sharpest = visit_form(p.shape, []<class Form>(Form) { return Form::kSharpestAt; });
    for (const double tau : {sharpest, 1 - sharpest}) {
      if (inside(tau * p.duration)) box.jerk.add(evaluate(p, tau * p.duration).jerk);
    }
  } else if (p.rate != 0) {
    const double vertex = -p.acceleration / p.rate;
    if (inside(vertex)) box.speed.add(evaluate(p, vertex).speed);
  }
  return box;
}

inline PhaseBounds bounds(const Phase& p) { return bounds(p, 0.0, p.duration); }

}  // namespace toolpace
