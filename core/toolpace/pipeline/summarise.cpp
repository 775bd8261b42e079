#include "toolpace/pipeline/summarise.h"

#include <algorithm>
#include <cmath>

#include "toolpace/law/law_table.h"
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

/// Speed and its changes at the knots and between them.
void measure_spline(const TimeSpline& spline, Summary& summary) {
  const std::size_t halves = 2 * (spline.points() - 3);
  for (std::size_t i = 0; i <= halves; ++i) {
    const SplineState state = evaluate(spline, static_cast<double>(i) * spline.step / 2);
    summary.max_speed = std::max(summary.max_speed, state.speed);
    summary.max_acceleration = std::max(summary.max_acceleration, std::abs(state.acceleration));
    summary.max_jerk = std::max(summary.max_jerk, std::abs(state.jerk));
  }
}

}  // namespace

Summary summarise(const Outcome& o) {
  const auto& kinds = o.job->program->moves.kind;
  Summary s;
  s.blocks = static_cast<std::size_t>(std::count_if(kinds.begin(), kinds.end(), is_motion));
  for (std::size_t i = 0; i < o.path->size(); ++i) {
    if (!is_rotary_only(*o.path, i)) s.path_length += o.path->length[i];
  }
  s.cycle_time = o.plan.cycle_time();
  for (const Phase& phase : o.plan.phases) {
    const PhaseExtrema e = extrema(phase);
    s.max_speed = std::max(s.max_speed, e.max_speed);
    s.max_acceleration = std::max({s.max_acceleration, e.max_acceleration, e.max_deceleration});
    s.max_jerk = std::max(s.max_jerk, e.max_jerk);
  }
  for (const TimeSpline& spline : o.plan.splines) measure_spline(spline, s);
  if (!law_row(o.job->options.law).bounds_jerk) s.max_jerk = kUnlimited;
  measure_times(o, s);
  s.time_by_cause = time_by_cause(o.restraints);
  return s;
}

}  // namespace toolpace
