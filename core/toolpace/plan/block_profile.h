#pragma once
/// The profile inside one block: a ramp up, a cruise, a ramp down, each of which may vanish.

#include <algorithm>
#include <cmath>
#include <vector>

#include "toolpace/law/law.h"
#include "toolpace/limits/ramp_limits.h"
#include "toolpace/plan/increasing_root.h"

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

/// Writes phases one after another while time is summed with compensation and positions are set by the caller, so that
/// neither drifts over millions of blocks.
class PhaseWriter {
 public:
  explicit PhaseWriter(std::vector<Phase>& phases) : phases_(phases) {}

  double time() const { return time_; }

  /// Appends a phase at the present time; durations ≤ 0 are left out.
  void push(Phase phase) {
    if (!(phase.duration > 0)) return;
    phase.begin = time_;
    advance(phase.duration);
    phases_.push_back(phase);
  }

  /// Appends the phases of a ramp so that the first one starts at `position`.
  template <class Law>
  void push_ramp(double v0, double v1, const RampLimits& limits, double position) {
    const std::size_t first = phases_.size();
    Law::append_ramp(v0, v1, limits, phases_);
    if (phases_.size() == first) return;
    const double shift = position - phases_[first].distance;
    for (std::size_t i = first; i < phases_.size(); ++i) {
      phases_[i].distance += shift;
      phases_[i].begin = time_;
      advance(phases_[i].duration);
    }
  }

 private:
  /// Neumaier's sum: the error of 10⁶ additions stays that of one.
  void advance(double duration) {
    const double sum = sum_ + duration;
    carry_ += sum_ >= duration ? (sum_ - sum) + duration : (duration - sum) + sum_;
    sum_ = sum;
    time_ = sum_ + carry_;
  }

  std::vector<Phase>& phases_;
  double sum_ = 0.0, carry_ = 0.0, time_ = 0.0;
};

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
