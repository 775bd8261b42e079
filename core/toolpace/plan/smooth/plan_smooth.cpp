#include "toolpace/plan/smooth/plan_smooth.h"

#include <algorithm>
#include <cmath>

#include "toolpace/limits/ceilings.h"
#include "toolpace/plan/hold.h"
#include "toolpace/plan/plan.h"
#include "toolpace/plan/smooth/build_tube.h"
#include "toolpace/plan/smooth/tube_progress.h"

namespace toolpace {
namespace {

constexpr double kSamePeriod = 1e-6;  // [periods]
constexpr double kLeastTube = 0.1;    // of the tolerance

/// Segments begin … end − 1, from rest to rest.
struct Run {
  std::size_t begin, end;
  bool exact;
};

std::vector<Run> find_runs(const Path& path, const Commands& commands) {
  std::vector<Run> runs;
  std::size_t pause = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    bool stops = false;
    for (; pause < path.pauses.size() && path.pauses[pause].node <= i; ++pause) stops |= path.pauses[pause].node == i;
    const bool exact = !(commands[i].tolerance > 0);
    if (runs.empty() || stops || exact != runs.back().exact || is_rotary_only(path, i) != is_rotary_only(path, i - 1)) {
      runs.push_back({i, i, exact});
    }
    runs.back().end = i + 1;
  }
  return runs;
}

class SmoothPlanner {
 public:
  SmoothPlanner(const Path& path, const Commands& commands, const Machine& machine, const SpeedLimits& limits,
                const PlanOptions& options, TubeEffort effort)
      : path_(path),
        commands_(commands),
        machine_(machine),
        limits_(limits),
        options_(options),
        effort_(effort),
        position_(node_positions(limits)) {
    result_.node_time.assign(path.size() + 1, 0.0);
    if (options.hold_at) hold_ = Hold{*options.hold_at};
  }

  Result<SmoothPlan> plan(const ForEach& for_each, const Monitor& monitor) {
    if (hold_) {
      if (auto checked = check_hold(*hold_); !checked) return tl::unexpected(checked.error());
    }
    for (const Run& run : find_runs(path_, commands_)) {
      if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
      hold_in_pause(run.begin);
      const auto added = run.exact ? add_exact(run, monitor) : add_tube(run, for_each, monitor);
      if (!added) return tl::unexpected(added.error());
    }
    hold_in_pause(path_.size());
    if (hold_) return tl::unexpected(hold_after_end(*hold_, time_ + paused_));
    return std::move(result_);
  }

 private:
  /// Passes the pauses up to a node; one that the hold falls into gets longer.
  void hold_in_pause(std::size_t node) {
    for (; pause_ < path_.pauses.size() && path_.pauses[pause_].node <= node; ++pause_) {
      paused_ += path_.pauses[pause_].duration;
    }
    if (!hold_ || hold_->time >= time_ + paused_) return;
    result_.plan.phases.push_back(
        {time_, hold_->pause, 0, 0, 0, 0, PhaseShape::constant_jerk, static_cast<std::uint32_t>(node)});
    time_ += hold_->pause;
    hold_.reset();
  }
  /// The hold as a run that begins now sees it.
  double hold_time() const { return hold_->time - time_ - paused_; }
  void set_node_time(const Run& run, std::size_t node, double time) {
    if (node > run.begin || node == 0) result_.node_time[node] = time;  // a pause there has not begun later
  }

  Result<void> add_exact(const Run& run, const Monitor& monitor) {
    const SpeedLimits part = slice(limits_, run.begin, run.end);
    auto plan = plan_motion(part, options_, {monitor.stop, {}});
    if (!plan) return tl::unexpected(plan.error());
    if (hold_ && hold_time() < plan->cycle_time()) {
      plan = insert_hold(part, *plan, options_, {hold_time(), hold_->pause}, {monitor.stop, {}});
      if (!plan) return tl::unexpected(plan.error());
      hold_.reset();
    }
    const double duration = plan->cycle_time();
    const std::vector<double> times = node_times(part, *plan);
    for (std::size_t i = 0; i < times.size(); ++i) set_node_time(run, run.begin + i, time_ + times[i]);
    for (Phase& phase : plan->phases) {
      phase.begin += time_;
      phase.node += static_cast<std::uint32_t>(run.begin);
      result_.plan.phases.push_back(phase);
    }
    time_ += duration;
    return {};
  }

  Result<void> add_tube(const Run& run, const ForEach& for_each, const Monitor& monitor) {
    TubePath tube = build_tube(path_, commands_, run.begin, run.end);
    const TubeLimits limits = tube_limits(under(machine_, lowest_ceiling(commands_, run.begin, run.end)));
    result_.took_lowest |= has_mixed_ceilings(commands_, run.begin, run.end);
    if (effort_ == TubeEffort::quick) leave_room_between(tube, limits);
    Monitor part{monitor.stop, {}};
    if (monitor.progress) {
      const double from = position_[run.begin], to = position_[run.end], all = position_.back();
      part.progress = [&monitor, from, to, all](double f) { monitor.report((from + f * (to - from)) / all); };
    }
    std::optional<TubeHold> hold;
    if (hold_) hold = TubeHold{hold_time(), hold_->pause};
    auto motion = plan_tube(tube, limits, machine_.period, for_each, part, hold, effort_);
    if (!motion) return tl::unexpected(motion.error());
    if (motion->held) hold_.reset();
    result_.deviation = std::max(result_.deviation, motion->deviation);
    result_.windows += motion->windows;
    result_.fallbacks += motion->fallbacks;
    const TubeProgress progress(tube, *motion);
    set_node_times(run, tube, *motion, progress);
    add_spline(run, tube, *motion);
    sketch(run, progress);
    time_ += motion->duration;
    return {};
  }

  /// The tube is held once a period from the run's begin on: setpoints that fall between those places may be off by the sag.
  void leave_room_between(TubePath& tube, const TubeLimits& limits) const {
    const double periods = (time_ + paused_) / machine_.period;
    if (std::abs(periods - std::round(periods)) <= kSamePeriod) return;
    double square = 0;
    for (int a = 0; a < tube.axes; ++a) {
      const auto axis = static_cast<std::size_t>(tube.axis[static_cast<std::size_t>(a)]);
      const double most = limits.acceleration[axis];
      square += most * most;
    }
    const double sag = std::sqrt(square) * machine_.period * machine_.period / 8;
    for (double& tolerance : tube.tolerance) tolerance = std::max(tolerance - sag, kLeastTube * tolerance);
  }

  void set_node_times(const Run& run, const TubePath& tube, const TubeMotion& motion, const TubeProgress& progress) {
    std::size_t k = 0;
    for (std::size_t i = run.begin; i <= run.end; ++i) {
      const double at = position_.between(run.begin, i);
      while (k + 1 < tube.segments() && tube.distance[k + 1] <= at) ++k;
      set_node_time(run, i, time_ + (at <= tube.distance[k] ? motion.pass[k] : progress.time_at(k, at)));
    }
    result_.node_time[run.end] = time_ + motion.duration;
  }

  void add_spline(const Run& run, const TubePath& tube, TubeMotion& motion) {
    TimeSpline spline;
    spline.begin = time_;
    spline.step = motion.step;
    spline.axes = tube.axes;
    spline.axis = tube.axis;
    spline.rest = path_.node[run.begin];
    spline.control = std::move(motion.control);
    const auto axes = static_cast<std::size_t>(tube.axes);
    for (std::size_t a = 0; a < axes; ++a) {
      const auto axis = static_cast<std::size_t>(tube.axis[a]);
      if (!is_rotary(axis)) continue;
      for (std::size_t i = a; i < spline.control.size(); i += axes) spline.control[i] *= kRadiansPerDegree;
    }
    result_.plan.splines.push_back(std::move(spline));
  }

  /// Phases, one a knot interval, that say where along the path the spline is and how fast.
  void sketch(const Run& run, const TubeProgress& progress) {
    const TimeSpline& spline = result_.plan.splines.back();
    const std::size_t cells = spline.points() - 3;
    const auto begin = static_cast<std::uint32_t>(run.begin);
    double speed = along(spline, evaluate(spline, 0.0)).speed;
    for (std::size_t i = 0; i < cells; ++i) {
      const double t = static_cast<double>(i) * spline.step;
      const double next = along(spline, evaluate(spline, t + spline.step)).speed;
      result_.plan.phases.push_back({time_ + t, spline.step, progress.at_knot(i), speed, (next - speed) / spline.step,
                                     0.0, PhaseShape::constant_jerk, begin});
      speed = next;
    }
  }

  const Path& path_;
  const Commands& commands_;
  const Machine& machine_;
  const SpeedLimits& limits_;
  const PlanOptions& options_;
  TubeEffort effort_;
  NodePositions position_;
  std::optional<Hold> hold_;  ///< that is not in the plan yet
  double time_ = 0;           ///< of the plan so far, without the path's pauses
  double paused_ = 0;         ///< by the path so far
  std::size_t pause_ = 0;
  SmoothPlan result_;
};

}  // namespace

Result<SmoothPlan> plan_smooth(const Path& path, const Commands& commands, const Machine& machine,
                               const SpeedLimits& limits, const PlanOptions& options, const ForEach& for_each,
                               const Monitor& monitor, TubeEffort effort) {
  return SmoothPlanner(path, commands, machine, limits, options, effort).plan(for_each, monitor);
}

}  // namespace toolpace
