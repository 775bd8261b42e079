#include "toolpace/pipeline/summarise.h"

#include <algorithm>
#include <cmath>

#include "toolpace/law/law_table.h"
#include "toolpace/law/phase_bounds.h"
#include "toolpace/plan/restraint.h"

namespace toolpace {
namespace {

bool stands_still(const Phase& phase) { return phase.speed == 0 && phase.acceleration == 0 && phase.rate == 0; }

void measure_times(const Outcome& o, Summary& summary) {
  const auto time_of = [&](std::size_t block) -> double& {
    return (*o.commands)[block].is_rapid() ? summary.rapid_time : summary.feed_time;
  };
  for (std::size_t i = 0; i < o.path->size(); ++i) time_of(i) += o.node_time[i + 1] - o.node_time[i];
  // node_time is the arrival: a rest counts to the block that follows it, unless it stands at the very end.
  for (const Phase& phase : o.plan.phases) {
    if (!stands_still(phase)) continue;
    summary.dwell_time += phase.duration;
    const auto after = std::upper_bound(o.node_time.begin(), o.node_time.end(), phase.begin);
    if (after != o.node_time.end() && after != o.node_time.begin()) {
      time_of(static_cast<std::size_t>(after - o.node_time.begin()) - 1) -= phase.duration;
    }
  }
}

void include(double speed, double acceleration, double jerk, Peaks& peaks) {
  peaks.speed = std::max(peaks.speed, speed);
  peaks.acceleration = std::max(peaks.acceleration, std::abs(acceleration));
  peaks.jerk = std::max(peaks.jerk, std::abs(jerk));
}

void include(const PhaseBounds& b, Peaks& peaks) {
  include(b.speed.high, std::max(b.acceleration.high, -b.acceleration.low), std::max(b.jerk.high, -b.jerk.low), peaks);
}

/// Peaks of either kind of motion: a ramp may run from one into the other.
class PeakMeter {
 public:
  PeakMeter(const Outcome& outcome, Summary& summary) : outcome_(outcome), summary_(summary) {}

  void measure() {
    for (const Phase& phase : outcome_.plan.phases) measure_phase(phase);
    segment_ = 0;
    for (const TimeSpline& spline : outcome_.plan.splines) measure_spline(spline);
  }

 private:
  std::size_t segments() const { return outcome_.path->size(); }
  double arrival(std::size_t node) const { return outcome_.node_time[node]; }

  void go_to(double time) {
    while (segment_ + 1 < segments() && arrival(segment_ + 1) <= time) ++segment_;
  }
  Peaks& peaks() {
    const bool rotary = segments() > 0 && is_rotary_only(*outcome_.path, segment_);
    return rotary ? summary_.rotary_peaks : summary_.peaks;
  }

  void measure_phase(const Phase& phase) {
    double from = 0;
    for (go_to(phase.begin); segment_ + 1 < segments(); ++segment_) {
      const double node = arrival(segment_ + 1) - phase.begin;
      if (node >= phase.duration) break;
      include(bounds(phase, from, std::max(from, node)), peaks());
      from = std::max(from, node);
    }
    include(bounds(phase, from, phase.duration), peaks());
  }

  /// At the knots and between them. A spline is either of rotary axes alone or not.
  void measure_spline(const TimeSpline& spline) {
    go_to(spline.begin);
    const std::size_t halves = 2 * (spline.points() - 3);
    for (std::size_t i = 0; i <= halves; ++i) {
      const SplineState state = evaluate(spline, static_cast<double>(i) * spline.step / 2);
      include(state.speed, state.acceleration, state.jerk, peaks());
    }
  }

  const Outcome& outcome_;
  Summary& summary_;
  std::size_t segment_ = 0;
};

}  // namespace

Summary summarise(const Outcome& o) {
  const auto& kinds = o.job->program->moves.kind;
  Summary s;
  s.blocks = static_cast<std::size_t>(std::count_if(kinds.begin(), kinds.end(), is_motion));
  for (std::size_t i = 0; i < o.path->size(); ++i) {
    if (!is_rotary_only(*o.path, i)) s.path_length += o.path->length[i];
  }
  s.cycle_time = o.plan.cycle_time();
  PeakMeter(o, s).measure();
  if (!law_row(o.ran.law).bounds_jerk) {
    for (Peaks* peaks : {&s.peaks, &s.rotary_peaks}) peaks->jerk = peaks->speed > 0 ? kUnlimited : 0;
  }
  measure_times(o, s);
  s.time_by_cause = time_by_cause(o.restraints);
  return s;
}

}  // namespace toolpace
