#pragma once
/// How planners write their phases.

#include <cmath>
#include <vector>

#include "toolpace/law/phase_list.h"
#include "toolpace/limits/ramp_limits.h"

namespace toolpace::detail {

/// Writes phases one after another while time is summed with compensation and distances are set by the caller, from a node
/// near by, so that neither drifts over millions of blocks.
class PhaseWriter {
 public:
  explicit PhaseWriter(std::vector<Phase>& phases) : phases_(phases) {}

  double time() const { return time_; }

  /// From here on distances count from this node of the chain.
  void count_from(std::size_t node) { node_ = static_cast<std::uint32_t>(node); }

  /// Appends a phase at the present time; durations ≤ 0 are left out.
  void push(Phase phase) {
    if (!(phase.duration > 0)) return;
    phase.begin = time_;
    phase.node = node_;
    advance(phase.duration);
    phases_.push_back(phase);
  }

  /// Appends phases whose times count from 0. May take their storage.
  void splice(std::vector<Phase>& phases) {
    const double end = phases.empty() ? 0.0 : phases.back().begin + phases.back().duration;
    if (phases_.empty() && time_ == 0) {
      phases_.swap(phases);
    } else {
      for (Phase& p : phases) p.begin += time_;
      phases_.insert(phases_.end(), phases.begin(), phases.end());
    }
    advance(end);
  }

  /// The last phase where it is a cruise at this speed, which push_cruise() makes longer; else null.
  const Phase* cruise_at(double speed) const {
    if (phases_.empty()) return nullptr;
    const Phase& last = phases_.back();
    return last.speed == speed && last.acceleration == 0 && last.rate == 0 ? &last : nullptr;
  }

  /// Appends a cruise from one place to another, joined with the cruise before it where that had the same speed.
  void push_cruise(double from, double to, double speed) {
    if (!(to > from)) return;
    if (cruise_at(speed) != nullptr) {
      Phase& last = phases_.back();
      const double longer = last.node == node_ ? (to - last.distance) / speed : last.duration + (to - from) / speed;
      advance(longer - last.duration);
      last.duration = longer;
      return;
    }
    push({0, (to - from) / speed, from, speed, 0, 0, PhaseShape::constant_jerk});
  }

  /// Appends a change of speed at constant acceleration, joined with the one before it where that had the same one.
  void push_straight(double from, double v0, double v1, double acceleration) {
    if (!phases_.empty() && phases_.back().acceleration == acceleration && phases_.back().rate == 0) {
      Phase& last = phases_.back();
      const double longer = (v1 - last.speed) / acceleration;
      advance(longer - last.duration);
      last.duration = longer;
      return;
    }
    push({0, (v1 - v0) / acceleration, from, v0, acceleration, 0, PhaseShape::constant_jerk});
  }

  /// Appends the phases of a ramp so that the first one starts at `position`.
  template <class Law>
  void push_ramp(double v0, double v1, const RampLimits& limits, double position) {
    PhaseList ramp;
    Law::append_ramp(v0, v1, limits, ramp);
    for (Phase p : ramp) {
      p.distance += position;
      push(p);
    }
  }

 private:
  /// Neumaier's sum: the error of 10⁶ additions stays that of one.
  void advance(double duration) {
    const double sum = sum_ + duration;
    carry_ += sum_ >= std::abs(duration) ? (sum_ - sum) + duration : (duration - sum) + sum_;
    sum_ = sum;
    time_ = sum_ + carry_;
  }

  std::vector<Phase>& phases_;
  std::uint32_t node_ = 0;
  double sum_ = 0.0, carry_ = 0.0, time_ = 0.0;
};

}  // namespace toolpace::detail
