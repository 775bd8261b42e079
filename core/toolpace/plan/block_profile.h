#pragma once
/// The profile inside one block: a ramp up, a cruise, a ramp down, each of which may vanish.

#include <algorithm>
#include <cmath>

#include "toolpace/law/law.h"
#include "toolpace/limits/ramp_limits.h"
#include "toolpace/plan/increasing_root.h"
#include "toolpace/plan/phase_writer.h"

namespace toolpace::detail {

/// Ramps that are longer than their block by no more than this share of it are rounding, not infeasible.
inline constexpr double kFit = 1e-12;

template <class Law>
bool fits(double v0, double v1, double length, const Dynamics& dynamics) {
  return ramp_length<Law>(v0, v1, v1 > v0 ? dynamics.up : dynamics.down) <= length * (1 + kFit);
}

/// A block as its profile sees it.
struct Stretch {
  double begin;        ///< path position of its start [mm]
  double length;       ///< [mm]
  double cap;          ///< top speed [mm/s]
  double entry, exit;  ///< [mm/s] ≤ cap
};

/// Highest speed of a stretch: the largest vp ≤ cap with d(entry→vp) + d(vp→exit) ≤ length; max(entry, exit) where
/// not even a small rise fits (the gap of laws whose ramps last a fixed time).
/// @pre fits<Law>(entry, exit, length)
/// @source Ning et al. 2014, section 2 (the seven shapes); Zheng et al. 2014, eqs. (27)–(29)
template <class Law>
double peak_speed(const Stretch& s, const Dynamics& dynamics) {
  const double low = std::max(s.entry, s.exit);
  const auto excess = [&](double peak) {
    return ramp_length<Law>(s.entry, peak, dynamics.up) + ramp_length<Law>(peak, s.exit, dynamics.down) - s.length;
  };
  const double at_cap = excess(s.cap);
  if (at_cap <= s.length * kFit || s.cap <= low) return std::max(s.cap, low);
  const double at_low = excess(low);
  if (at_low >= 0) return low;
  // Jerk-limited lengths grow with √(vp − low): in that root they are smooth and the search converges fast.
  const double root =
      increasing_root(0.0, std::sqrt(s.cap - low), at_low, at_cap, [&](double w) { return excess(low + w * w); });
  return low + root * root;
}

/// Time of the stretch's fastest profile [s].
template <class Law>
double stretch_time(const Stretch& s, const Dynamics& dynamics) {
  const double peak = peak_speed<Law>(s, dynamics);
  const double up = Law::duration(peak - s.entry, dynamics.up);
  const double down = Law::duration(peak - s.exit, dynamics.down);
  const double rest = s.length - (s.entry + peak) / 2 * up - (peak + s.exit) / 2 * down;
  return up + down + std::max(0.0, rest) / peak;
}

/// Appends the stretch's fastest profile.
template <class Law>
void append_stretch(const Stretch& s, const Dynamics& dynamics, PhaseWriter& out) {
  const double peak = peak_speed<Law>(s, dynamics);
  const double up = ramp_length<Law>(s.entry, peak, dynamics.up);
  const double down = ramp_length<Law>(peak, s.exit, dynamics.down);
  // A remainder below the rounding of the ramps' lengths is no cruise.
  double cruise = s.length - up - down;
  if (!(cruise > s.length * 1e-13)) cruise = 0.0;
  if (peak > s.entry) out.template push_ramp<Law>(s.entry, peak, dynamics.up, s.begin);
  if (cruise > 0) out.push({0, cruise / peak, s.begin + up, peak, 0.0, 0.0, PhaseShape::constant_jerk});
  if (peak > s.exit) out.template push_ramp<Law>(peak, s.exit, dynamics.down, s.begin + (s.length - down));
}

}  // namespace toolpace::detail
