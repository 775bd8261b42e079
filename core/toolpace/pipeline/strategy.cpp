#include "toolpace/pipeline/strategy.h"

#include <algorithm>
#include <thread>

#include "toolpace/base/part_monitor.h"
#include "toolpace/law/law_table.h"
#include "toolpace/pipeline/job_rules.h"
#include "toolpace/pipeline/many.h"
#include "toolpace/plan/plan.h"
#include "toolpace/plan/retime/retime.h"

namespace toolpace {
namespace {

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

SmoothPlan with_node_times(MotionPlan plan, const SpeedLimits& limits) {
  SmoothPlan result;
  result.node_time = node_times(limits, plan);
  result.plan = std::move(plan);
  return result;
}

// Along the path: by the job's own law.

bool takes_any(const Job&, std::size_t) { return true; }

Result<SmoothPlan> plan_along_path(const PlanTask& task, const Monitor& monitor) {
  auto plan = plan_motion(task.limits, task.job.options, monitor);
  if (!plan) return tl::unexpected(plan.error());
  return with_node_times(std::move(*plan), task.limits);
}

PlanOptions as_asked(const PlanTask& task) { return task.job.options; }

Settings nothing(const PlanTask&) { return {}; }

// Timed anew: curves under the axes' limits themselves, with jerk and acceleration shared as the motion needs it. Other laws
// have a shape to keep; a window, and a hold, want caps that can be braked from.

bool may_be_timed_anew(const Job& job, std::size_t segments) {
  const PlanOptions& o = job.options;
  const bool jerk_law = o.law == LawKind::seven_phase || o.law == LawKind::time_optimal;
  return job.refined && jerk_law && o.ramps == Ramps::span && blends_everywhere(job) && !o.lookahead && !o.hold_at &&
         segments <= kMostRetimed;
}

Result<SmoothPlan> plan_anew(const PlanTask& task, const Monitor& monitor) {
  const auto first = plan_motion(task.limits, task.job.options, part_of(monitor, 0.0, 0.5));
  if (!first) return tl::unexpected(first.error());
  MotionPlan plan = retime(task.path, task.commands, task.job.machine, task.limits, *first, on_all_cores(monitor),
                           part_of(monitor, 0.5, 1.0));
  if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
  return with_node_times(std::move(plan), task.limits);
}

PlanOptions time_optimal(const PlanTask& task) {
  PlanOptions ran = task.job.options;
  ran.law = LawKind::time_optimal;
  return ran;
}

// Through the tube.

bool goes_through_tube(const Job& job, std::size_t) { return is_through_tube(job); }

Result<SmoothPlan> plan_through_tube(const PlanTask& task, const Monitor& monitor) {
  return plan_smooth(task.path, task.commands, task.job.machine, task.limits, task.job.options, on_all_cores(monitor),
                     monitor);
}

/// Blocks under G61 and G61.1 stay on the path, and are planned by the job's own law.
bool has_exact_blocks(const PlanTask& task) {
  return std::any_of(task.commands.begin(), task.commands.end(), [](const Command& c) { return is_exact(c.control); });
}

PlanOptions of_tube(const PlanTask& task) {
  if (has_exact_blocks(task)) return task.job.options;
  PlanOptions ran = time_optimal(task);
  ran.ramps = Ramps::span;
  ran.lookahead.reset();
  return ran;
}

Settings ignored_by_tube(const PlanTask& task) {
  if (has_exact_blocks(task)) return {};
  return {Setting::law, Setting::ramps, Setting::lookahead};
}

constexpr Strategy kStrategies[] = {
    {"through-tube", goes_through_tube, plan_through_tube, of_tube, ignored_by_tube},
    {"timed-anew", may_be_timed_anew, plan_anew, time_optimal, nothing},
    {"along-path", takes_any, plan_along_path, as_asked, nothing},
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
