#include "toolpace/pipeline/job_rules.h"

#include <algorithm>
#include <tuple>

#include "toolpace/law/law_table.h"

namespace toolpace {

bool is_through_tube(const Job& job) {
  return job.options.corner.rule == CornerRule::smooth && !job.options.corner.step;
}

bool is_about_tip(const Job& job) { return job.program && job.program->moves.has_tip(); }

bool blends_everywhere(const Job& job) {
  return job.options.corner.rule == CornerRule::blend && !job.options.corner.step;
}

Rounding rounding(const CornerOptions& corner) {
  const bool rounds = corner.rule == CornerRule::blend || corner.rule == CornerRule::smooth;
  return {corner.tolerance, rounds && !corner.step};
}

Commands command(const Path& path, const Job& job) {
  CommandOptions options = command_options(job.machine);
  options.feed_override = job.options.feed_override;
  options.rapid_override = job.options.rapid_override;
  options.rounding = rounding(job.options.corner);
  return command_path(path, job.program->moves, options);
}

std::size_t motion_blocks(const Moves& moves) {
  return static_cast<std::size_t>(std::count_if(moves.kind.begin(), moves.kind.end(), is_motion));
}

bool sees_all(const Job& job) {
  const auto& depth = job.options.lookahead;
  return !depth || (*depth > 0 && job.program && *depth >= motion_blocks(job.program->moves));
}

bool stops_at_steps(const PlanOptions& options) {
  const CornerOptions& corner = options.corner;
  const bool has_steps = corner.step || corner.rule == CornerRule::servo || corner.rule == CornerRule::junction;
  return options.shaper != ShaperKind::none && has_steps;
}

std::shared_ptr<const Job> as_planned(std::shared_ptr<const Job> job) {
  const bool looks_at_all = job->options.lookahead && sees_all(*job), stops = stops_at_steps(job->options);
  if (!looks_at_all && !stops) return job;
  auto planned = std::make_shared<Job>(*job);
  if (looks_at_all) planned->options.lookahead.reset();
  if (stops) {
    planned->options.corner.rule = CornerRule::stop;
    planned->options.corner.step.reset();
  }
  return planned;
}

double time_at_feeds(const Path& path, const Commands& commands) {
  double time = 0;
  for (std::size_t i = 0; i < path.size(); ++i) time += path.length[i] / commands[i].speed;
  return time;
}

LimitOptions limit_options(const PlanOptions& options) {
  LimitOptions limits;
  limits.corner = options.corner;
  limits.rapid_override = options.rapid_override;
  limits.keeps_jerk = law_row(options.law).bounds_jerk;
  if (law_row(options.law).uses_time) {
    limits.t_acc = options.t_acc;
    limits.t_dec = options.t_dec;
  }
  return limits;
}

bool has_same_route(const Job& a, const Job& b) {
  return a.program == b.program && a.machine.tool_change == b.machine.tool_change &&
         blends_everywhere(a) == blends_everywhere(b) && a.options.corner.tolerance == b.options.corner.tolerance;
}

bool has_same_limits(const Job& a, const Job& b) {
  const auto of_path = [](const PathLimits& p) {
    return std::tie(p.speed, p.acceleration, p.deceleration, p.jerk, p.jerk_deceleration, p.fine_acceleration);
  };
  const auto of_axis = [](const AxisLimits& x) { return std::tie(x.speed, x.acceleration, x.jerk); };
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    if (of_axis(a.machine.axes[k]) != of_axis(b.machine.axes[k])) return false;
  }
  const LimitOptions of_a = limit_options(a.options), of_b = limit_options(b.options);
  const auto of_options = [](const LimitOptions& o) {
    return std::tie(o.corner.rule, o.corner.step, o.corner.tolerance, o.corner.junction_deviation, o.rapid_override,
                    o.keeps_jerk, o.t_acc, o.t_dec);
  };
  return a.machine.period == b.machine.period && of_path(a.machine.path) == of_path(b.machine.path) &&
         of_options(of_a) == of_options(of_b) && a.options.feed_override == b.options.feed_override;
}

}  // namespace toolpace
