#include <algorithm>
#include <cmath>

#include "toolpace/law/law_table.h"
#include "toolpace/limits/limit_speed.h"
#include "toolpace/path/build_path.h"
#include "toolpace/pipeline/job.h"
#include "toolpace/pipeline/pauses.h"
#include "toolpace/pipeline/setup.h"
#include "toolpace/pipeline/travel.h"
#include "toolpace/plan/bound.h"
#include "toolpace/plan/plan.h"
#include "toolpace/plan/restraint.h"

namespace toolpace {
namespace {

/// A monitor that maps a stage's 0 … 1 onto its share of the whole.
Monitor stage(const Monitor& whole, double begin, double end) {
  if (!whole.progress) return {whole.stop, {}};
  return {whole.stop, [report = whole.progress, begin, end](double f) { report(begin + f * (end - begin)); }};
}

LimitOptions limit_options(const PlanOptions& options) {
  LimitOptions limits;
  limits.corner = options.corner;
  limits.feed_override = options.feed_override;
  limits.rapid_override = options.rapid_override;
  if (law_row(options.law).uses_time) {
    limits.t_acc = options.t_acc;
    limits.t_dec = options.t_dec;
  }
  return limits;
}

void measure_times(const Outcome& o, const Moves& moves, Summary& summary) {
  for (std::size_t i = 0; i < o.path->size(); ++i) {
    const double time = o.node_time[i + 1] - o.node_time[i];
    (moves.kind[o.path->move[i]] == MoveKind::rapid ? summary.rapid_time : summary.feed_time) += time;
  }
  for (const Path::Pause& pause : o.path->pauses) summary.dwell_time += pause.duration;
  // node_time is the arrival: a pause counts to the block that follows it, or stands at the very end.
  for (const Path::Pause& pause : o.path->pauses) {
    if (pause.node >= o.path->size()) continue;
    const bool rapid = moves.kind[o.path->move[pause.node]] == MoveKind::rapid;
    (rapid ? summary.rapid_time : summary.feed_time) -= pause.duration;
  }
}

Summary summarise(const Outcome& o, const Moves& moves) {
  Summary s;
  s.blocks = static_cast<std::size_t>(std::count_if(moves.kind.begin(), moves.kind.end(), is_motion));
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
  if (!law_row(o.job->options.law).bounds_jerk) s.max_jerk = kUnlimited;
  measure_times(o, moves, s);
  s.time_by_cause = time_by_cause(o.restraints);
  if (o.job->bound) s.bound = lower_bound(o.limits, o.job->options.law) + s.dwell_time;
  return s;
}

/// Arrival at each node in a plan with pauses: the planner's times, later by the pauses before the node.
std::vector<double> delayed_times(std::vector<double> times, const std::vector<Path::Pause>& pauses) {
  double delay = 0.0;
  std::size_t next = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    times[i] += delay;
    for (; next < pauses.size() && pauses[next].node == i; ++next) delay += pauses[next].duration;
  }
  return times;
}

}  // namespace

Result<Outcome> run(std::shared_ptr<const Job> job, const Monitor& monitor) {
  const Moves& moves = job->program->moves;
  if (auto checked = check_setup(job->machine, job->options); !checked) return tl::unexpected(checked.error());

  auto path = build_path(moves, job->machine.tool_change, stage(monitor, 0.0, 0.2));
  if (!path) return tl::unexpected(path.error());
  auto limits = limit_speed(*path, moves, job->machine, limit_options(job->options), stage(monitor, 0.2, 0.4));
  if (!limits) return tl::unexpected(limits.error());
  auto plan = plan_motion(*limits, job->options, stage(monitor, 0.4, 0.9));
  if (!plan) return tl::unexpected(plan.error());

  Outcome outcome;
  outcome.job = std::move(job);
  outcome.path = std::make_shared<const Path>(std::move(*path));
  outcome.limits = std::move(*limits);
  outcome.node_time = delayed_times(node_times(outcome.limits, *plan), outcome.path->pauses);
  outcome.plan = insert_pauses(*plan, outcome.path->pauses, node_positions(outcome.limits));
  outcome.restraints = explain(outcome.limits, outcome.plan, outcome.node_time, outcome.job->options);
  outcome.warnings = check_travel(*outcome.path, moves, outcome.job->machine);
  outcome.summary = summarise(outcome, moves);
  monitor.report(1.0);
  return outcome;
}

}  // namespace toolpace
