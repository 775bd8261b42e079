#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "toolpace/base/part_monitor.h"
#include "toolpace/limits/limit_speed.h"
#include "toolpace/machine/setup.h"
#include "toolpace/path/build_path.h"
#include "toolpace/pipeline/job.h"
#include "toolpace/pipeline/job_rules.h"
#include "toolpace/pipeline/many.h"
#include "toolpace/pipeline/pauses.h"
#include "toolpace/pipeline/prove.h"
#include "toolpace/pipeline/replan.h"
#include "toolpace/pipeline/summarise.h"
#include "toolpace/pipeline/travel.h"
#include "toolpace/pipeline/tube_bound.h"
#include "toolpace/plan/bound.h"
#include "toolpace/plan/hold.h"
#include "toolpace/plan/plan.h"
#include "toolpace/plan/restraint.h"
#include "toolpace/plan/retime/retime.h"
#include "toolpace/plan/smooth/plan_smooth.h"
#include "toolpace/plan/smooth/spline_restraint.h"

namespace toolpace {
namespace {

/// Segments of a path whose plan is timed anew: it costs many times the plan itself.
constexpr std::size_t kMostRetimed = 50000;

/// Are a plan's curves timed anew, with jerk and acceleration shared as the motion needs it? Other laws have a shape to
/// keep; a window, and a hold, want caps that can be braked from.
bool is_retimed(const Job& job, std::size_t segments) {
  const PlanOptions& o = job.options;
  const bool jerk_law = o.law == LawKind::seven_phase || o.law == LawKind::time_optimal;
  return job.refined && jerk_law && o.ramps == Ramps::span && o.corner.rule == CornerRule::blend && !o.corner.step &&
         !o.lookahead && !o.hold_at && segments <= kMostRetimed;
}

/// Rounded paths are timed under the axes' limits themselves, and the caps of their curves are no bound. No motion gains
/// speed with more than all axes' accelerations together.
double bound_of(const Outcome& o) {
  if (!is_retimed(*o.job, o.path->size())) return lower_bound(o.limits, o.job->options.law);
  SpeedLimits open = o.limits;
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (o.path->kind[i] != SegmentKind::line) open.block_cap[i] = (*o.commands)[i].speed;
  }
  for (std::size_t i = 1; i < open.size(); ++i) {
    if (open.node_cap[i] > 0) open.node_cap[i] = std::min(open.block_cap[i - 1], open.block_cap[i]);
  }
  double square = 0;
  for (std::size_t k = 0; k < kAxisCount; ++k) square += std::pow(o.job->machine.axes[k].acceleration, 2);
  for (Dynamics& d : open.dynamics) {
    d.up.acceleration = std::min(o.job->machine.path.acceleration, std::sqrt(square));
    d.down.acceleration = std::min(o.job->machine.path.deceleration, std::sqrt(square));
  }
  return lower_bound(open, LawKind::trapezoid);
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

/// On all cores; what the tasks compute does not depend on how many there are.
ForEach on_all_cores(const Monitor& monitor) {
  return [&monitor](std::size_t count, const std::function<void(std::size_t)>& task) {
    const auto threads = std::max(1u, std::thread::hardware_concurrency());
    // Cancelling is the tasks' own business.
    (void)for_many<char>(count, threads, {monitor.stop, {}}, [&](std::size_t i, const Monitor&) -> Result<char> {
      task(i);
      return '\0';
    });
  };
}

/// Plans by the job's corner rule: along the path, or through the tube around it.
Result<SmoothPlan> plan_rule(const Path& path, const Commands& commands, const Job& job, const SpeedLimits& limits,
                             const Monitor& monitor) {
  if (is_through_tube(job)) {
    return plan_smooth(path, commands, job.machine, limits, job.options, on_all_cores(monitor), monitor);
  }
  auto plan = plan_motion(limits, job.options, part_of(monitor, 0.0, 0.5));
  if (!plan) return tl::unexpected(plan.error());
  if (is_retimed(job, path.size())) {
    *plan = retime(path, commands, job.machine, limits, *plan, on_all_cores(monitor), part_of(monitor, 0.5, 1.0));
    if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
  }
  SmoothPlan result;
  result.node_time = node_times(limits, *plan);
  result.plan = std::move(*plan);
  return result;
}

/// Which limit binds when, along the path and through the tube.
std::vector<Restraint> explain_all(const Outcome& o) {
  return explain_splines(explain(o.limits, o.plan, o.node_time, o.job->options), o.plan, o.job->machine, *o.commands,
                         o.node_time);
}

/// A feed or a dwell that nobody meant may last for years.
Result<void> check_duration(double cycle_time, double period) {
  constexpr double kMostSetpoints = 1e9;
  const double setpoints = cycle_time / period;
  if (setpoints <= kMostSetpoints) return {};
  return tl::unexpected(Error{ErrorKind::input,
                              "motion-too-long",
                              std::isfinite(setpoints) ? fmt::format("the program takes {:.4g} days, {:.3g} setpoints",
                                                                     cycle_time / 86400, setpoints)
                                                       : "the program takes longer than can be counted",
                              "check feeds and dwells, or take a longer period",
                              {},
                              {}});
}

/// Where the machine goes, however fast.
struct Route {
  std::shared_ptr<const Path> path;
  BlendCount blends;
};

/// How fast it is told to go there, and how fast it may.
struct Speeds {
  std::shared_ptr<const Commands> commands;
  SpeedLimits limits;
};

Result<Route> lay_out(const Job& job, const Monitor& monitor) {
  const Moves& moves = job.program->moves;
  auto path = build_path(moves, job.machine.tool_change, part_of(monitor, 0.0, 0.15));
  if (!path) return tl::unexpected(path.error());
  BlendCount blends;
  if (!is_through_tube(job) && (blends_everywhere(job) || asks_for_blends(moves))) {
    auto blended = blend_path(*path, moves, rounding(job.options.corner), part_of(monitor, 0.15, 0.2));
    if (!blended) return tl::unexpected(blended.error());
    path = std::move(blended->path);
    blends = blended->count;
  }
  return Route{std::make_shared<const Path>(std::move(*path)), blends};
}

Result<Speeds> speeds_on(const Path& path, const Job& job, const Monitor& monitor) {
  auto commands = std::make_shared<const Commands>(command(path, job));
  auto limits = limit_speed(path, *commands, job.machine, limit_options(job.options), part_of(monitor, 0.2, 0.4));
  if (!limits) return tl::unexpected(limits.error());
  return Speeds{std::move(commands), std::move(*limits)};
}

Result<Outcome> plan_along(std::shared_ptr<const Job> job, Route route, Result<Speeds> speeds, const Monitor& monitor) {
  if (!speeds) return tl::unexpected(speeds.error());
  auto planned = plan_rule(*route.path, *speeds->commands, *job, speeds->limits, part_of(monitor, 0.4, 0.9));
  if (!planned) return tl::unexpected(planned.error());

  Outcome outcome;
  outcome.job = std::move(job);
  outcome.path = std::move(route.path);
  outcome.commands = std::move(speeds->commands);
  outcome.limits = std::move(speeds->limits);
  outcome.node_time = delayed_times(std::move(planned->node_time), outcome.path->pauses);
  outcome.plan = insert_pauses(std::move(planned->plan), outcome.path->pauses, node_positions(outcome.limits));
  if (const auto hold = outcome.job->options.hold_at; hold && !is_through_tube(*outcome.job)) {
    auto held = insert_hold(outcome.limits, outcome.plan, outcome.job->options, {*hold}, part_of(monitor, 0.9, 0.95));
    if (!held) return tl::unexpected(held.error());
    outcome.plan = std::move(*held);
    outcome.node_time = node_times(outcome.limits, outcome.plan);
  }
  if (auto fits = check_duration(outcome.plan.cycle_time(), outcome.job->machine.period); !fits)
    return tl::unexpected(fits.error());
  outcome.restraints = explain_all(outcome);
  outcome.warnings = check_travel(*outcome.path, outcome.job->program->moves, outcome.job->machine);
  outcome.summary = summarise(outcome);
  if (outcome.job->bound && !is_through_tube(*outcome.job))
    outcome.summary.bound = bound_of(outcome) + outcome.summary.dwell_time;
  outcome.summary.blends = route.blends;
  outcome.summary.tube_deviation = planned->deviation;
  outcome.summary.tube_windows = planned->windows;
  outcome.summary.tube_fallbacks = planned->fallbacks;
  monitor.report(1.0);
  return outcome;
}

/// Plans by the job's own corner rule, whether another one would be faster or not.
Result<Outcome> plan_job(std::shared_ptr<const Job> job, const Monitor& monitor) {
  if (auto checked = check_setup(job->machine, job->options); !checked) return tl::unexpected(checked.error());
  auto route = lay_out(*job, monitor);
  if (!route) return tl::unexpected(route.error());
  auto speeds = speeds_on(*route->path, *job, monitor);
  return plan_along(std::move(job), std::move(*route), std::move(speeds), monitor);
}

/// The same job with corner curves, which keep the same tolerance.
std::shared_ptr<Job> with_blends(const Job& job) {
  auto blended = std::make_shared<Job>(job);
  blended->options.corner.rule = CornerRule::blend;
  blended->options.ramps = Ramps::span;
  blended->options.lookahead.reset();
  return blended;
}

bool is_proven(const Outcome& outcome, const Monitor& monitor) {
  const auto report = prove(outcome, {monitor.stop, {}});
  return report && report->passes();
}

/// Whether one plan may stand for another: faster, and proven by its setpoints.
bool is_better(const Outcome& one, const Outcome& other, const Monitor& monitor) {
  return one.summary.cycle_time < other.summary.cycle_time && is_proven(one, monitor);
}

/// What no motion through the job's tube beats, whichever was taken.
Result<Outcome> with_tube_bound(Outcome outcome) {
  const Job& job = *outcome.job;
  if (!job.bound) return outcome;
  const auto programmed = build_path(job.program->moves, job.machine.tool_change);
  if (!programmed) return tl::unexpected(programmed.error());
  const double tolerance = judged_tolerance(job.program->moves, job.options.corner);
  outcome.summary.bound =
      tube_bound(*programmed, command(*programmed, job), job.machine, tolerance) + outcome.summary.dwell_time;
  return outcome;
}

Diagnostic not_smoothed(const std::string& why, const std::string& remedy) {
  return {Severity::warning, "smooth-fell-back", why + ", so corners are blended", remedy, {}, {}};
}

}  // namespace

Result<Outcome> run(std::shared_ptr<const Job> job, const Monitor& monitor) {
  if (!is_through_tube(*job)) return plan_job(std::move(job), monitor);
  // Where the feed and not the corners decide, curves that end on the exact path can be a little faster.
  auto blended = plan_job(with_blends(*job), part_of(monitor, 0.0, 0.1));
  auto smooth = plan_job(job, part_of(monitor, 0.1, 0.95));
  const bool unbounded = !smooth && smooth.error().code == "tube-unbounded";
  if (!smooth && !(unbounded && blended)) return smooth;
  if (!blended) return with_tube_bound(std::move(*smooth));
  blended->job = std::move(job);
  if (unbounded) blended->warnings.push_back(not_smoothed(smooth.error().message, smooth.error().remedy));
  bool takes_blended = unbounded || is_better(*blended, *smooth, monitor);
  // The tube is held at some places of each step; where a dwell is no whole number of periods, setpoints fall between them.
  if (!takes_blended && !is_proven(*smooth, monitor) && is_proven(*blended, monitor)) {
    takes_blended = true;
    blended->warnings.push_back(not_smoothed("setpoints of the motion through the tube do not pass every check", ""));
  }
  if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
  monitor.report(1.0);
  return with_tube_bound(std::move(takes_blended ? *blended : *smooth));
}

Result<Outcome> replan(std::shared_ptr<const Job> job, const Outcome& before, const Monitor& monitor) {
  // A job through the tube may have been given blends, so its path does not tell how it was made.
  const bool reusable = before.job && before.path && !is_through_tube(*job) && !is_through_tube(*before.job);
  if (!reusable || !has_same_route(*job, *before.job)) return run(std::move(job), monitor);
  if (auto checked = check_setup(job->machine, job->options); !checked) return tl::unexpected(checked.error());
  auto speeds = has_same_limits(*job, *before.job) ? Speeds{before.commands, before.limits}
                                                   : speeds_on(*before.path, *job, monitor);
  return plan_along(std::move(job), {before.path, before.summary.blends}, std::move(speeds), monitor);
}

bool takes_long(const Job& job) {
  return is_through_tube(job) || is_retimed(job, job.program ? job.program->moves.size() : 0);
}

std::shared_ptr<const Job> quick_version(const Job& job) {
  auto quick = is_through_tube(job) ? with_blends(job) : std::make_shared<Job>(job);
  quick->refined = false;
  return quick;
}

}  // namespace toolpace
