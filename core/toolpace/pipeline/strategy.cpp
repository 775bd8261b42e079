#include "toolpace/pipeline/strategy.h"

#include <algorithm>
#include <thread>

#include "toolpace/base/part_monitor.h"
#include "toolpace/law/law_table.h"
#include "toolpace/pipeline/job_rules.h"
#include "toolpace/pipeline/many.h"
#include "toolpace/pipeline/prove.h"
#include "toolpace/plan/plan.h"
#include "toolpace/plan/retime/retime.h"
#include "toolpace/plan/settle_curves.h"

namespace toolpace {
namespace {

/// Plans that last no longer are timed anew from more than one start [s].
constexpr double kBrief = 30;
/// Segments of a path whose plan is timed anew: it costs many times the plan itself.
constexpr std::size_t kMostRetimed = 50000;

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

// Along the path: by the job's own law.

bool takes_any(const Job&, std::size_t) { return true; }

/// Limits with curves as the plan to come can use them: ramps inside blocks come to rest at the caps, but for a feed hold.
/// @param depth  the look-ahead for which the curves' caps are chosen
Result<SpeedLimits> settled(const PlanTask& task, const PlanOptions& o, std::size_t depth, const Monitor& monitor) {
  if (task.limits.curved.empty()) return std::move(task.limits);
  const AtCap at_cap = o.ramps == Ramps::block && !o.hold_at ? AtCap::rests : AtCap::changes;
  SpeedLimits limits = settle_curves(task.limits, {o.law, at_cap, depth, is_about_tip(task.job)}, {monitor.stop, {}});
  if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());  // half settled they fit nothing
  return limits;
}

std::size_t depth_of(const PlanTask& task) { return task.job.options.lookahead.value_or(task.limits.size()); }

Result<Planned> plan_with(const PlanTask& task, const PlanOptions& options, std::size_t depth, const Monitor& monitor) {
  auto limits = settled(task, options, depth, monitor);
  if (!limits) return tl::unexpected(limits.error());
  Planned planned;
  planned.limits = std::move(*limits);
  planned.ran = task.job.options;
  auto plan = plan_motion(planned.limits, options, monitor);
  if (!plan) return tl::unexpected(plan.error());
  planned.motion.plan = std::move(*plan);
  return planned;
}

/// Depths for which the caps of curves are chosen. What suits a plan that sees all need not suit one that sees a few blocks. A
/// deeper look-ahead tries all that a shallower one does, so that it is never the slower one; where there are many curves that
/// costs too much, and only a stop everywhere is tried besides.
std::vector<std::size_t> depths_tried(const PlanTask& task) {
  constexpr std::size_t kFewCurves = 300;
  const std::size_t all = task.limits.size(), depth = depth_of(task);
  if (sees_all(task.job) || depth == 1 || depth >= all) return {depth};
  std::vector<std::size_t> depths{all};
  const std::size_t deepest = task.limits.curved.size() <= kFewCurves ? depth : 1;
  for (std::size_t d = 1; d <= deepest; d *= 2) depths.push_back(d);
  return depths;
}

/// The fastest of the plans that the job allows. Ramps inside their blocks leave curves more than ramps across them.
Result<Planned> plan_phases(const PlanTask& task, PlanOptions options, const Monitor& monitor) {
  if (task.limits.curved.empty()) return plan_with(task, options, depth_of(task), monitor);
  // About the tool's tip every block may be a curve: of many, ramps inside them would cost several times the plan itself.
  constexpr std::size_t kManyCurves = 2000;
  const bool has_many_curves = is_about_tip(task.job) && task.limits.curved.size() > kManyCurves;
  std::vector<std::pair<Ramps, std::size_t>> ways;
  for (const std::size_t depth : depths_tried(task)) {
    if (options.ramps == Ramps::span) ways.emplace_back(Ramps::span, depth);
    if (options.ramps != Ramps::span || !has_many_curves) ways.emplace_back(Ramps::block, depth);
  }
  Result<Planned> best;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    options.ramps = ways[i].first;
    const double share = 1.0 / static_cast<double>(ways.size());
    auto planned = plan_with(task, options, ways[i].second,
                             part_of(monitor, share * static_cast<double>(i), share * static_cast<double>(i + 1)));
    if (!planned) return planned;
    if (i == 0 || planned->motion.plan.cycle_time() < best->motion.plan.cycle_time()) best = std::move(planned);
  }
  return best;
}

Result<Planned> plan_along_path(const PlanTask& task, const Monitor& monitor) {
  auto planned = plan_phases(task, task.job.options, monitor);
  if (planned) planned->motion.node_time = node_times(planned->limits, planned->motion.plan);
  return planned;
}

// Timed anew: curves under the axes' limits themselves, with jerk and acceleration shared as the motion needs it. A window, and
// a hold, want caps that can be braked from.

bool has_programmed_curves(const Job& job) {
  if (!job.program) return false;
  const auto& kinds = job.program->moves.kind;
  return std::any_of(kinds.begin(), kinds.end(),
                     [](MoveKind k) { return k == MoveKind::arc || k == MoveKind::spline; });
}

bool has_rounded_corners(const Job& job) {
  return job.program && (blends_everywhere(job) || asks_for_blends(job.program->moves));
}

/// About the tool's tip lines are curves of the axes.
bool has_curves(const Job& job) { return has_rounded_corners(job) || has_programmed_curves(job) || is_about_tip(job); }

/// Rounded corners by a quick motion through the tube: as what is timed anew, but of any length.
bool goes_quickly_through_tube(const Job& job, std::size_t) {
  const PlanOptions& o = job.options;
  return job.refined && o.ramps == Ramps::span && sees_all(job) && !o.hold_at && !is_through_tube(job) &&
         !is_about_tip(job) && has_rounded_corners(job) && !law_row(o.law).uses_time;
}

bool may_be_timed_anew(const Job& job, std::size_t segments) {
  const PlanOptions& o = job.options;
  return job.refined && o.ramps == Ramps::span && sees_all(job) && !o.hold_at && segments <= kMostRetimed &&
         has_curves(job);
}

/// Rounded corners alone are left to the tube, which does them better and sooner, but where it is the feed that decides, and on
/// paths so short that it does not matter.
bool is_worth_timing_anew(const PlanTask& task, const MotionPlan& plan) {
  constexpr double kNearFeed = 1.25;   // of the time at the feeds
  constexpr std::size_t kShort = 200;  // segments
  if (has_programmed_curves(task.job) || !goes_quickly_through_tube(task.job, task.path.size())) return true;
  if (task.path.size() <= kShort) return true;
  return plan.cycle_time() < kNearFeed * time_at_feeds(task.path, task.commands);
}

/// A plan that is near what the limits allow, whatever the law: from there the way to the fastest one is short. Nothing where
/// the law's own plan is one.
Result<std::optional<MotionPlan>> start_for(const PlanTask& task, const Monitor& monitor) {
  PlanOptions options = task.job.options;
  const bool has_shape = law_row(options.law).bounds_jerk && options.law != LawKind::seven_phase;
  if (!has_shape || options.law == LawKind::time_optimal) return std::nullopt;
  options.law = LawKind::seven_phase;
  SpeedLimits limits = task.limits;
  const RampLimits along = ramps_timed_anew(task.job.options, task.commands.top_speed(), task.job.machine.path);
  const CurveShare most{along.acceleration, along.jerk};
  for (Dynamics& d : limits.dynamics) d = within(d, most);
  for (AlongPath& a : limits.along) a.dynamics = within(a.dynamics, most);
  auto quick = plan_phases({task.job, task.path, task.commands, limits}, options, monitor);
  if (!quick) return tl::unexpected(quick.error());
  return std::move(quick->motion.plan);
}

Result<Planned> plan_anew(const PlanTask& task, const Monitor& monitor) {
  if (task.limits.curved.empty()) return plan_along_path(task, monitor);
  auto planned = plan_phases(task, task.job.options, part_of(monitor, 0.0, 0.2));
  if (!planned) return planned;
  if (!is_worth_timing_anew(task, planned->motion.plan)) {
    planned->motion.node_time = node_times(planned->limits, planned->motion.plan);
    return planned;
  }
  const auto other = start_for(task, part_of(monitor, 0.2, 0.3));
  if (!other) return tl::unexpected(other.error());
  const MotionPlan own = planned->motion.plan;
  const RetimeTask retiming{task.path, task.commands, task.job.machine, planned->limits, task.job.options};
  std::vector<const MotionPlan*> starts{*other ? &**other : &own};
  // The way to the fastest motion may end before it: where it costs little another start is tried.
  if (*other && own.cycle_time() <= kBrief) starts.push_back(&own);
  std::optional<MotionPlan> timed;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const double share = 0.7 / static_cast<double>(starts.size());
    auto one = retime(retiming, own, *starts[i], on_all_cores(monitor),
                      part_of(monitor, 0.3 + share * static_cast<double>(i), 0.3 + share * static_cast<double>(i + 1)));
    if (one && (!timed || one->cycle_time() < timed->cycle_time())) timed = std::move(one);
  }
  if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
  if (timed) {
    planned->motion.plan = std::move(*timed);
    // What is timed anew is as fast as the limits allow; five-phase-time's least durations are among these.
    const LawRow& law = law_row(task.job.options.law);
    if (law.bounds_jerk && !law.uses_time) planned->ran.law = LawKind::time_optimal;
  }
  planned->motion.node_time = node_times(planned->limits, planned->motion.plan);
  return planned;
}

// Through the tube.

bool goes_through_tube(const Job& job, std::size_t) { return is_through_tube(job); }

/// Blocks without a tolerance (G61, G61.1) stay on the path, and are planned by the job's own law.
bool has_exact_blocks(const PlanTask& task) {
  return std::any_of(task.commands.begin(), task.commands.end(), [](const Command& c) { return !(c.tolerance > 0); });
}

Result<Planned> plan_through_tube(const PlanTask& task, const Monitor& monitor) {
  auto limits = settled(task, task.job.options, depth_of(task), monitor);
  if (!limits) return tl::unexpected(limits.error());
  Planned planned;
  planned.ran = task.job.options;
  planned.limits = std::move(*limits);
  auto motion = plan_smooth(task.path, task.commands, task.job.machine, planned.limits, task.job.options,
                            on_all_cores(monitor), monitor);
  if (!motion) return tl::unexpected(motion.error());
  planned.motion = std::move(*motion);
  if (has_exact_blocks(task)) return planned;
  planned.ran.law = LawKind::time_optimal;
  planned.ran.ramps = Ramps::span;
  planned.ran.lookahead.reset();
  planned.ignored = {Setting::law, Setting::ramps, Setting::lookahead};
  return planned;
}

/// A wide tube may cost a search of few rounds more than it gains: of short paths narrower ones are tried too.
int tubes_tried(std::size_t segments) {
  constexpr std::size_t kShared = 1000, kMost = 4;
  return static_cast<int>(std::min(kMost, 1 + kShared / std::max<std::size_t>(segments, 1)));
}

/// In place of corner curves: jerk counts where the law keeps it.
Result<Planned> plan_quickly_through_tube(const PlanTask& task, const Monitor& monitor) {
  auto limits = settled(task, task.job.options, depth_of(task), monitor);
  if (!limits) return tl::unexpected(limits.error());
  Planned planned;
  planned.ran = task.job.options;
  planned.limits = std::move(*limits);
  const Machine machine = judged_machine(task.job.machine, task.job.options);
  const int tubes = tubes_tried(task.path.size());
  Commands commands = task.commands;
  for (int i = 0; i < tubes; ++i) {
    auto motion = plan_smooth(task.path, commands, machine, planned.limits, task.job.options, on_all_cores(monitor),
                              part_of(monitor, static_cast<double>(i) / tubes, (i + 1.0) / tubes), TubeEffort::quick);
    if (!motion) return tl::unexpected(motion.error());
    if (i == 0 || motion->plan.cycle_time() < planned.motion.plan.cycle_time()) planned.motion = std::move(*motion);
    for (Command& c : commands) c.tolerance /= 2;
  }
  if (law_row(planned.ran.law).bounds_jerk && !has_exact_blocks(task)) planned.ran.law = LawKind::time_optimal;
  return planned;
}

constexpr Strategy kStrategies[] = {
    {"through-tube", true, goes_through_tube, plan_through_tube},
    {"quickly-through-tube", true, goes_quickly_through_tube, plan_quickly_through_tube},
    {"timed-anew", false, may_be_timed_anew, plan_anew},
    {"along-path", false, takes_any, plan_along_path},
};

bool has_jerk_limit(const Machine& machine) {
  return machine.path.jerk < kUnlimited ||
         std::any_of(machine.axes.begin(), machine.axes.end(), [](const AxisLimits& a) { return a.jerk < kUnlimited; });
}

/// Corners blended inside the tolerance of a tube, and, as in the tube, as fast as the limits allow, whatever the law.
std::shared_ptr<Job> with_blends(const Job& job) {
  auto blended = std::make_shared<Job>(job);
  blended->options.corner.rule = CornerRule::blend;
  blended->options.law = has_jerk_limit(job.machine) ? LawKind::time_optimal : LawKind::trapezoid;
  blended->options.ramps = Ramps::span;
  blended->options.lookahead.reset();
  return blended;
}

}  // namespace

const Strategy& strategy_of(const Job& job, std::size_t segments, bool leaves_path) {
  return *std::find_if(std::begin(kStrategies), std::end(kStrategies),
                       [&](const Strategy& s) { return s.leaves_path == leaves_path && s.takes(job, segments); });
}

bool may_leave_path(const Job& job) { return job.program && goes_quickly_through_tube(job, job.program->moves.size()); }

const Strategy& strategy_of(const Job& job, std::size_t segments) {
  return *std::find_if(std::begin(kStrategies), std::end(kStrategies),
                       [&](const Strategy& s) { return s.takes(job, segments); });
}

std::optional<Candidate> rival_of(const Job& job) {
  if (!is_through_tube(job)) return {};
  return Candidate{with_blends(job), {Setting::law, Setting::ramps, Setting::lookahead}};
}

Settings unused_settings(const PlanOptions& ran, const Commands& commands) {
  Settings unused;
  const LawRow& law = law_row(ran.law);
  if (!law.uses_time) unused.include({Setting::t_acc, Setting::t_dec});
  if (!law.bounds_jerk) unused.include(Setting::jerk);
  if (ran.corner.step) unused.include(Setting::corner);
  if (ran.corner.step || ran.corner.rule != CornerRule::junction) unused.include(Setting::junction_deviation);
  const bool rounds = std::any_of(commands.begin(), commands.end(), [](const Command& c) { return c.tolerance > 0; });
  if (!rounds) unused.include(Setting::tolerance);
  return unused;
}

bool takes_long(const Job& job) {
  return strategy_of(job, job.program ? job.program->moves.size() : 0).plan != plan_along_path;
}

std::shared_ptr<const Job> quick_version(const Job& job) {
  auto quick = is_through_tube(job) ? with_blends(job) : std::make_shared<Job>(job);
  quick->refined = false;
  return quick;
}

}  // namespace toolpace
