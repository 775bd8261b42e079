#include "toolpace/pipeline/summarise.h"

#include <algorithm>
#include <cmath>

#include "toolpace/law/law_table.h"
#include "toolpace/plan/restraint.h"
#include "toolpace/sample/motion.h"

namespace toolpace {
namespace {

bool stands_still(const Phase& phase) { return phase.speed == 0 && phase.acceleration == 0 && phase.rate == 0; }

void measure_times(const Outcome& o, Summary& summary) {
  const auto time_of = [&](std::size_t block) -> double& {
    return (*o.commands)[block].is_rapid ? summary.rapid_time : summary.feed_time;
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

void include(const PhaseBounds& b, Peaks& peaks) {
  peaks.speed = std::max(peaks.speed, b.speed.high);
  peaks.acceleration = std::max({peaks.acceleration, b.acceleration.high, -b.acceleration.low});
  peaks.jerk = std::max({peaks.jerk, b.jerk.high, -b.jerk.low});
}

/// Peaks of either kind of motion: a ramp may run from one into the other.
void measure_peaks(const Outcome& o, Summary& summary) {
  Motion motion(*o.path, o.plan);
  for (std::size_t i = 0; i < o.path->size(); ++i) {
    include(motion.bounds(o.node_time[i], o.node_time[i + 1]),
            is_rotary_only(*o.path, i) ? summary.rotary_peaks : summary.peaks);
  }
}

}  // namespace

Summary summarise(const Outcome& o) {
  Summary s;
  s.blocks = motion_blocks(o.job->program->moves);
  for (std::size_t i = 0; i < o.path->size(); ++i) {
    if (!is_rotary_only(*o.path, i)) s.path_length += o.path->length[i];
  }
  s.cycle_time = o.plan.cycle_time();
  measure_peaks(o, s);
  if (!law_row(o.ran.law).bounds_jerk) {
    for (Peaks* peaks : {&s.peaks, &s.rotary_peaks}) peaks->jerk = peaks->speed > 0 ? kUnlimited : 0;
  }
  measure_times(o, s);
  s.time_by_cause = time_by_cause(o.restraints);
  return s;
}

}  // namespace toolpace
