#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "toolpace/base/part_monitor.h"
#include "toolpace/limits/axes_there.h"
#include "toolpace/limits/limit_speed.h"
#include "toolpace/limits/travel.h"
#include "toolpace/machine/setup.h"
#include "toolpace/path/build_path.h"
#include "toolpace/path/cut_for_axes.h"
#include "toolpace/path/turn_tool.h"
#include "toolpace/pipeline/job.h"
#include "toolpace/pipeline/job_rules.h"
#include "toolpace/pipeline/prove.h"
#include "toolpace/pipeline/ramp_times.h"
#include "toolpace/pipeline/replan.h"
#include "toolpace/pipeline/strategy.h"
#include "toolpace/pipeline/summarise.h"
#include "toolpace/plan/hold.h"
#include "toolpace/plan/pauses.h"
#include "toolpace/plan/plan.h"
#include "toolpace/plan/restraint.h"
#include "toolpace/plan/smooth/spline_restraint.h"

namespace toolpace {
namespace {

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

/// Which limit binds when, along the path and through the tube.
std::vector<Restraint> explain_all(const Outcome& o) {
  return explain_splines(explain(o.limits, o.plan, o.node_time, o.ran), o.plan, o.job->machine, *o.commands,
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

/// What of the program's limits the plan could not follow as they are told.
Diagnostics check_ceilings(const Outcome& o, bool took_lowest) {
  Diagnostics warnings;
  const auto warn = [&](const char* code, std::string message, std::string remedy) {
    warnings.push_back({Severity::warning, code, std::move(message), std::move(remedy), {}, {}});
  };
  if (took_lowest) {
    warn("limits-change-in-tube",
         "the program changes its limits within a motion that rounds corners: the lowest of them hold in all of it",
         "--corner servo follows each of them");
  }
  const auto& ceilings = o.commands->ceilings;
  const bool limits_corners =
      std::any_of(ceilings.begin(), ceilings.end(), [](const MotionCeiling& c) { return c.limits_corners(); });
  if (limits_corners && (is_through_tube(*o.job) || blends_everywhere(*o.job))) {
    warn("corner-limit-without-effect",
         "corners are rounded here: what the program says of their speed counts only where one is not",
         "--corner servo follows it");
  }
  const bool asks_for_accuracy =
      std::any_of(ceilings.begin(), ceilings.end(), [](const MotionCeiling& c) { return c.accuracy > 0; });
  if (asks_for_accuracy && !(o.job->machine.path.fine_acceleration < kUnlimited)) {
    warn("limit-without-effect",
         "the program asks for accuracy at the cost of acceleration (G187 P, G5.1 R), but the machine does not say how "
         "much",
         "give fine_acceleration_mm_s2 in [path]");
  }
  return warnings;
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

/// @param rounds  whether corners get curves where the job wants them
Result<Route> lay_out(const Job& job, bool rounds, const Monitor& monitor) {
  const Moves& moves = job.program->moves;
  auto path = build_path(moves, job.machine.tool_change, part_of(monitor, 0.0, 0.15));
  if (!path) return tl::unexpected(path.error());
  BlendCount blends;
  if (rounds && (blends_everywhere(job) || asks_for_blends(moves))) {
    auto blended = blend_path(*path, moves, rounding(job.options.corner), part_of(monitor, 0.15, 0.2));
    if (!blended) return tl::unexpected(blended.error());
    path = std::move(blended->path);
    blends = blended->count;
  }
  return Route{std::make_shared<const Path>(cut_for_axes(std::move(*path))), blends};
}

Result<Speeds> speeds_on(const Path& path, const Job& job, const Monitor& monitor) {
  auto commands = std::make_shared<const Commands>(command(path, job));
  auto limits = limit_speed(path, *commands, job.machine, limit_options(job.options), part_of(monitor, 0.2, 0.4));
  if (!limits) return tl::unexpected(limits.error());
  return Speeds{std::move(commands), std::move(*limits)};
}

Result<Outcome> plan_along(std::shared_ptr<const Job> job, const Strategy& strategy, Route route, Result<Speeds> speeds,
                           const Monitor& monitor) {
  if (!speeds) return tl::unexpected(speeds.error());
  const PlanTask task{*job, *route.path, *speeds->commands, speeds->limits};
  auto planned = strategy.plan(task, part_of(monitor, 0.4, 0.9));
  if (!planned) return tl::unexpected(planned.error());

  Outcome outcome;
  outcome.ran = planned->ran;
  outcome.ignored = planned->ignored;
  outcome.ignored.include(unused_settings(outcome.ran, *speeds->commands));
  outcome.job = std::move(job);
  outcome.path = std::move(route.path);
  outcome.commands = std::move(speeds->commands);
  outcome.limits = std::move(planned->limits);
  SmoothPlan& motion = planned->motion;
  outcome.node_time = delayed_times(std::move(motion.node_time), outcome.path->pauses);
  outcome.plan = insert_pauses(std::move(motion.plan), outcome.path->pauses, outcome.path->position);
  if (const auto hold = outcome.job->options.hold_at; hold && !is_through_tube(*outcome.job)) {
    auto held = insert_hold(outcome.limits, outcome.plan, outcome.job->options, {*hold}, part_of(monitor, 0.9, 0.95));
    if (!held) return tl::unexpected(held.error());
    outcome.plan = std::move(*held);
    outcome.node_time = node_times(outcome.limits, outcome.plan);
  }
  if (auto fits = check_duration(outcome.plan.cycle_time(), outcome.job->machine.period); !fits)
    return tl::unexpected(fits.error());
  outcome.restraints = explain_all(outcome);
  const Moves& moves = outcome.job->program->moves;
  outcome.warnings = check_axes(*outcome.path, moves, outcome.job->machine);
  const Diagnostics planes = check_planes(*outcome.path, moves);
  outcome.warnings.insert(outcome.warnings.end(), planes.begin(), planes.end());
  const Diagnostics travel = check_travel(*outcome.path, moves, outcome.job->machine);
  outcome.warnings.insert(outcome.warnings.end(), travel.begin(), travel.end());
  const Diagnostics ceilings = check_ceilings(outcome, motion.took_lowest);
  outcome.warnings.insert(outcome.warnings.end(), ceilings.begin(), ceilings.end());
  outcome.summary = summarise(outcome);
  outcome.summary.blends = route.blends;
  outcome.summary.tube_deviation = motion.deviation;
  outcome.summary.tube_windows = motion.windows;
  outcome.summary.tube_fallbacks = motion.fallbacks;
  auto dear_ramps = check_ramp_times(outcome, part_of(monitor, 0.95, 1.0));
  if (!dear_ramps) return tl::unexpected(dear_ramps.error());
  if (*dear_ramps) outcome.warnings.push_back(**dear_ramps);
  monitor.report(1.0);
  return outcome;
}

/// What becomes of corners.
enum class Corners {
  as_programmed,  ///< crossed as the rule of corners says; where they should be rounded, stopped at
  rounded,        ///< on the path, where the job wants them to be
  left            ///< for the tube
};

Result<Outcome> plan_by(std::shared_ptr<const Job> job, Corners corners, const Monitor& monitor) {
  const bool leaves_path = corners == Corners::left;
  auto route = lay_out(*job, corners == Corners::rounded, monitor);
  if (!route) return tl::unexpected(route.error());
  auto speeds = speeds_on(*route->path, *job, monitor);
  const Strategy& strategy = strategy_of(*job, route->path->size(), leaves_path);
  return plan_along(std::move(job), strategy, std::move(*route), std::move(speeds), monitor);
}

bool fell_back_often(const Outcome& through) {
  constexpr double kMostFallen = 0.1;  // of windows
  return static_cast<double>(through.summary.tube_fallbacks) >
         kMostFallen * static_cast<double>(through.summary.tube_windows);
}

/// Whether the path itself, with rounded corners or stops at them, may be faster than a motion through the tube: where feeds
/// and not corners decide, where feeds change, where the tube fell back, and on short paths, where it is cheap to try.
bool may_be_beaten(const Outcome& through) {
  constexpr std::size_t kShort = 1000;               // segments
  constexpr double kNearFeed = 1.25, kMixed = 0.05;  // of the time at the feeds; of segments
  const Path& path = *through.path;
  const Commands& commands = *through.commands;
  if (path.size() <= kShort || fell_back_often(through)) return true;
  const double commanded = through.summary.dwell_time + time_at_feeds(path, commands);
  std::size_t changes = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    changes += i > 0 && commands[i].speed != commands[i - 1].speed;
  }
  return through.summary.cycle_time < kNearFeed * commanded ||
         static_cast<double>(changes) > kMixed * static_cast<double>(path.size());
}

Result<Outcome> faster_of(Result<Outcome> one, Result<Outcome> other) {
  if (!one || (other && other->summary.cycle_time < one->summary.cycle_time)) return other;
  return one;
}

/// A quick motion through the tube, rounded corners on the path, or stops at them, whichever is fastest.
Result<Outcome> plan_rounded(const std::shared_ptr<const Job>& job, const Monitor& monitor) {
  auto best = plan_by(job, Corners::left, part_of(monitor, 0.0, 0.6));
  if (best && !may_be_beaten(*best)) return best;
  const bool can_stop = blends_everywhere(*job);  // else other corners are crossed by another rule
  auto rounded = plan_by(job, Corners::rounded, part_of(monitor, 0.6, 0.95));
  if (!rounded) return rounded;
  best = faster_of(std::move(rounded), std::move(best));
  if (can_stop) best = faster_of(std::move(best), plan_by(job, Corners::as_programmed, part_of(monitor, 0.95, 1.0)));
  if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
  return best;
}

/// Plans by the job's own corner rule, whether another one would be faster or not.
Result<Outcome> plan_job(std::shared_ptr<const Job> job, const Monitor& monitor) {
  if (auto checked = check_setup(job->machine, job->options); !checked) return tl::unexpected(checked.error());
  if (may_leave_path(*job)) return plan_rounded(job, monitor);
  const Corners corners = is_through_tube(*job) ? Corners::left : Corners::rounded;
  return plan_by(std::move(job), corners, monitor);
}

/// Whether one plan may stand for another: faster, and proven by its setpoints.
bool is_better(const Outcome& one, const Outcome& other, const Monitor& monitor) {
  return one.summary.cycle_time < other.summary.cycle_time && is_proven(one, {monitor.stop, {}});
}

/// The outcome of a job that stands for another.
Result<Outcome> outcome_of(std::shared_ptr<const Job> asked, Result<Outcome> made) {
  if (!made) return made;
  if (stops_at_steps(asked->options)) {
    made->warnings.push_back(
        {Severity::warning,
         "shaper-stops",
         "shaped setpoints stop at corners: the steps of speed that the corner rule allows cannot be shaped",
         "--corner blend or smooth rounds them; --verify tells how far the shaped path is from the program",
         {},
         {}});
  }
  made->job = std::move(asked);
  return made;
}

Diagnostic not_smoothed(const std::string& why, const std::string& remedy) {
  return {Severity::warning, "smooth-fell-back", why + ", so corners are blended", remedy, {}, {}};
}

/// Why the motion through the tube was not taken, and what that costs.
Diagnostic not_proven(const Outcome& smooth, const Outcome& blended, const Result<std::vector<Check>>& broken) {
  const std::string cost =
      fmt::format("{:.4g} s instead of {:.4g} s", blended.summary.cycle_time, smooth.summary.cycle_time);
  if (!broken || broken->empty())
    return not_smoothed("setpoints of the motion through the tube could not be judged (" + cost + ")", "");
  const Check& check = broken->front();
  const CheckUnit unit = check_unit(check);
  const std::string excess = fmt::format("{} would be {:.6g} {} where {:.6g} is allowed", check_title(check),
                                         check.value / unit.size, unit.symbol, check.limit / unit.size);
  Diagnostic warning = not_smoothed(
      fmt::format("through the tube {}, at {:.3f} s, line {} ({})", excess, check.time, check.line, cost), "");
  warning.where.line = check.line;
  const auto& files = smooth.job->program->moves.files;
  if (!files.empty()) warning.where.file = files.front();
  return warning;
}

/// The tube is one of straight axes.
Result<Outcome> plan_blended_about_tip(const Candidate& rival, const Monitor& monitor) {
  auto blended = plan_job(rival.job, monitor);
  if (!blended) return blended;
  blended->ignored.include(rival.ignored);
  blended->warnings.push_back(not_smoothed("a program about the tool's tip cannot be run through the tolerance tube",
                                           "--corner blend asks for that at once"));
  return blended;
}

/// What may stand for a motion through the tube: rounded corners, by all ways to plan them where the tube is no good.
/// @param asked    the job for which it stands
/// @param through  that motion, if there is one
Result<Outcome> plan_rival(const std::shared_ptr<const Job>& asked, const Candidate& rival, const Outcome* through,
                           const Monitor& monitor) {
  auto blended = through && !fell_back_often(*through) ? plan_by(rival.job, Corners::rounded, monitor)
                                                       : plan_job(rival.job, monitor);
  if (!blended) return blended;
  blended->ignored.include(rival.ignored);
  blended->job = asked;
  return blended;
}

/// Setpoints tell: the tube is held at some places of each step, and where a dwell is no whole number of periods they fall
/// between them.
Result<Outcome> proven_or_rival(Outcome smooth, const Candidate& rival, std::optional<Outcome> blended,
                                const Monitor& monitor) {
  const auto broken = broken_checks(smooth, {monitor.stop, {}});
  if (broken && broken->empty()) return smooth;
  if (!blended) {
    auto late = plan_rival(smooth.job, rival, nullptr, monitor);
    if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
    if (late) blended = std::move(*late);
  }
  if (!blended || !is_proven(*blended, {monitor.stop, {}})) return smooth;
  blended->warnings.push_back(not_proven(smooth, *blended, broken));
  return std::move(*blended);
}

Result<Outcome> run_whole(std::shared_ptr<const Job> job, const Monitor& monitor) {
  const auto rival = rival_of(*job);
  if (!rival) return plan_job(std::move(job), monitor);
  if (is_about_tip(*job)) return plan_blended_about_tip(*rival, monitor);
  auto smooth = plan_job(job, part_of(monitor, 0.0, 0.8));
  if (!smooth) {
    if (smooth.error().code != "tube-unbounded") return smooth;
    auto blended = plan_rival(job, *rival, nullptr, part_of(monitor, 0.8, 1.0));
    if (blended) blended->warnings.push_back(not_smoothed(smooth.error().message, smooth.error().remedy));
    return blended;
  }
  std::optional<Outcome> blended;
  if (may_be_beaten(*smooth)) {
    auto planned = plan_rival(job, *rival, &*smooth, part_of(monitor, 0.8, 0.95));
    if (planned) blended = std::move(*planned);
  }
  // Where the feed and not the corners decide, curves that end on the exact path can be a little faster.
  const bool takes_blended = blended && is_better(*blended, *smooth, monitor);
  auto taken = takes_blended
                   ? std::move(*blended)
                   : proven_or_rival(std::move(*smooth), *rival, std::move(blended), part_of(monitor, 0.95, 1.0));
  if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
  monitor.report(1.0);
  return taken;
}

}  // namespace

Result<Outcome> run(std::shared_ptr<const Job> job, const Monitor& monitor) {
  return outcome_of(job, run_whole(as_planned(job), monitor));
}

Result<Outcome> replan(std::shared_ptr<const Job> asked, const Outcome& before, const Monitor& monitor) {
  auto job = as_planned(asked);
  const auto had = before.job ? as_planned(before.job) : nullptr;
  // A job through the tube may have been given blends, so its path does not tell how it was made.
  const auto stays_on_path = [](const Job& j) { return !is_through_tube(j) && !may_leave_path(j); };
  const bool reusable = had && before.path && stays_on_path(*job) && stays_on_path(*had);
  if (!reusable || !has_same_route(*job, *had)) return run(std::move(asked), monitor);
  if (auto checked = check_setup(job->machine, job->options); !checked) return tl::unexpected(checked.error());
  // Limits of curves were chosen for the law and its ramps.
  const bool same = has_same_limits(*job, *had) && before.limits.curved.empty();
  auto speeds = same ? Speeds{before.commands, before.limits} : speeds_on(*before.path, *job, monitor);
  const Strategy& strategy = strategy_of(*job, before.path->size(), false);
  return outcome_of(std::move(asked), plan_along(std::move(job), strategy, {before.path, before.summary.blends},
                                                 std::move(speeds), monitor));
}

}  // namespace toolpace
