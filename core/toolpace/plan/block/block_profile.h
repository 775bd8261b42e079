#pragma once
/// The profile inside one block: a ramp up, a cruise, a ramp down, each of which may vanish.

#include <algorithm>
#include <cmath>

#include "toolpace/law/law.h"
#include "toolpace/law/peak_speed.h"
#include "toolpace/limits/ramp_limits.h"
#include "toolpace/plan/phase_writer.h"

namespace toolpace::detail {

/// Ramps that are longer than their block by no more than this share of it are rounding, not infeasible.
inline constexpr double kFit = 1e-12;

/// A block's ramp limits, and the durations that its law gives them.
struct Drive {
  const Dynamics& limits;
  const MoveTerms& terms;
};

/// Length of the ramp between two speeds [mm].
inline double ramp_length(double v0, double v1, const MoveTerms& terms) {
  return (v0 + v1) / 2 * (v1 > v0 ? terms.up.duration(v1 - v0) : terms.down.duration(v0 - v1));
}

inline bool fits(double v0, double v1, double length, const MoveTerms& terms) {
  return ramp_length(v0, v1, terms) <= length * (1 + kFit);
}

/// A block as its profile sees it.
struct Stretch {
  double length;       ///< [mm]
  double cap;          ///< top speed [mm/s]
  double entry, exit;  ///< [mm/s] ≤ cap
};

/// Ramps that change the speed by a smaller share are left out: speeds are rounded to 1e-16 of themselves, and so a tiny change
/// of a large speed, and with it the length of its ramp, is hardly known.
inline constexpr double kLeastChange = 1e-7;

/// Highest speed of a stretch that fits(entry, exit).
inline double peak_speed(const Stretch& s, const MoveTerms& terms) {
  const double ends = std::max(s.entry, s.exit);
  const double peak = toolpace::peak_speed({s.length, s.cap, s.entry, s.exit}, terms);
  return peak > ends * (1 + kLeastChange) ? peak : ends;
}

/// Time of a stretch's fastest profile [s].
/// @param peak  its peak_speed()
inline double stretch_time(const Stretch& s, double peak, const MoveTerms& terms) {
  const double up = terms.up.duration(peak - s.entry), down = terms.down.duration(peak - s.exit);
  const double rest = s.length - (s.entry + peak) / 2 * up - (peak + s.exit) / 2 * down;
  return up + down + std::max(0.0, rest) / peak;
}

inline double stretch_time(const Stretch& s, const MoveTerms& terms) {
  return stretch_time(s, peak_speed(s, terms), terms);
}

/// Appends the stretch's fastest profile, counted from its start: one of the seven shapes.
/// @source Ning et al. 2014, section 2
template <class Law>
void append_stretch(const Stretch& s, const Drive& drive, PhaseWriter& out) {
  const double peak = peak_speed(s, drive.terms);
  const double up = peak > s.entry ? ramp_length(s.entry, peak, drive.terms) : 0.0;
  const double down = peak > s.exit ? ramp_length(peak, s.exit, drive.terms) : 0.0;
  // A remainder below the rounding of the ramps' lengths is no cruise.
  double cruise = s.length - up - down;
  if (!(cruise > s.length * 2 * kFit)) cruise = 0.0;
  if (peak > s.entry) out.template push_ramp<Law>(s.entry, peak, drive.limits.up, 0.0);
  if (cruise > 0) out.push({0, cruise / peak, up, peak, 0.0, 0.0, PhaseShape::constant_jerk});
  if (peak > s.exit) out.template push_ramp<Law>(peak, s.exit, drive.limits.down, s.length - down);
}

/// Durations for each of a list of ramp limits.
template <class Law>
std::vector<MoveTerms> terms_of(const std::vector<Dynamics>& dynamics) {
  std::vector<MoveTerms> terms;
  terms.reserve(dynamics.size());
  for (const Dynamics& d : dynamics) terms.push_back(move_terms<Law>(d));
  return terms;
}

}  // namespace toolpace::detail
