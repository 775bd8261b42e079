#include "toolpace/pipeline/run_on_controller.h"

#include <algorithm>
#include <cmath>

#include "toolpace/base/part_monitor.h"
#include "toolpace/limits/limit_speed.h"
#include "toolpace/machine/controller_machine.h"
#include "toolpace/path/build_path.h"
#include "toolpace/pipeline/job_rules.h"
#include "toolpace/pipeline/summarise.h"
#include "toolpace/sample/motion.h"

namespace toolpace {
namespace {

bool is_rest(const Stage& s) { return s.from == 0 && s.to == 0; }
double way(const Stage& s) { return 0.5 * (s.from + s.to) * s.duration; }

/// Lays stages on the segments of the rows that they belong to.
class StageLayer {
 public:
  StageLayer(const Path& path, const std::vector<Stage>& stages, Outcome& outcome)
      : path_(path), stages_(stages), out_(outcome) {
    out_.node_time.assign(1, 0.0);
  }

  void run() {
    for (std::size_t i = 0, next; i < stages_.size(); i = next) {
      for (next = i + 1; next < stages_.size() && stages_[next].row == stages_[i].row;) ++next;
      add_row(i, next);
    }
    pass_to(path_.size());
  }

 private:
  /// Stages first … end − 1, of one row.
  void add_row(std::size_t first, std::size_t end) {
    const std::uint32_t row = stages_[first].row;
    std::size_t begin = segment_;
    while (begin < path_.size() && path_.move[begin] < row) ++begin;
    pass_to(begin);
    std::size_t behind = begin;
    double length = 0;
    for (; behind < path_.size() && path_.move[behind] == row; ++behind) length += path_.length[behind];
    double driven = 0;
    for (std::size_t i = first; i < end; ++i) driven += way(stages_[i]);
    const double scale = driven > 0 ? length / driven : 0.0;
    double at = 0;
    for (std::size_t i = first; i < end; ++i) {
      const Stage& s = stages_[i];
      add_phase(s, begin, at, scale);
      at += scale * way(s);
    }
    segment_ = behind;
  }

  void add_phase(const Stage& s, std::size_t node, double at, double scale) {
    if (scale == 0 || is_rest(s)) {
      add_rest(s, node, at);
      return;
    }
    const Phase phase{time_,
                      s.duration,
                      at,
                      scale * s.from,
                      scale * (s.to - s.from) / s.duration,
                      0,
                      PhaseShape::constant_jerk,
                      static_cast<std::uint32_t>(node)};
    out_.plan.phases.push_back(phase);
    restrain(s);
    for (; segment_ < path_.size() && reaches_end_of(segment_, phase); ++segment_) {
      out_.node_time.push_back(time_ + time_at(phase, end_of(segment_, node)));
    }
    time_ += s.duration;
  }

  void add_rest(const Stage& s, std::size_t node, double at) {
    out_.plan.phases.push_back(
        {time_, s.duration, at, 0, 0, 0, PhaseShape::constant_jerk, static_cast<std::uint32_t>(node)});
    restrain(s);
    time_ += s.duration;
  }

  double end_of(std::size_t segment, std::size_t node) const { return path_.position.between(node, segment + 1); }

  bool reaches_end_of(std::size_t segment, const Phase& phase) const {
    constexpr double kRounding = 1e-9;  // relative
    const double end = end_of(segment, phase.node);
    return end <= evaluate(phase, phase.duration).distance + kRounding * end;
  }

  /// When a phase is at a distance from its node that it reaches.
  static double time_at(const Phase& p, double distance) {
    const double left = std::max(0.0, distance - p.distance);
    const double root = std::sqrt(std::max(0.0, p.speed * p.speed + 2 * p.acceleration * left));
    return std::min(p.duration, root + p.speed > 0 ? 2 * left / (root + p.speed) : 0.0);
  }

  /// Nodes that nothing drives to.
  void pass_to(std::size_t segment) {
    for (; segment_ < segment; ++segment_) out_.node_time.push_back(time_);
  }

  void restrain(const Stage& s) {
    auto& list = out_.restraints;
    const Cause cause = cause_of(s.limit);
    if (!list.empty() && list.back().cause == cause) {
      list.back().end = time_ + s.duration;
      return;
    }
    const std::size_t block = std::min(segment_, std::max<std::size_t>(path_.size(), 1) - 1);
    list.push_back({time_, time_ + s.duration, static_cast<std::uint32_t>(block), cause});
  }

  const Path& path_;
  const std::vector<Stage>& stages_;
  Outcome& out_;
  std::size_t segment_ = 0;  ///< the first whose end is not reached
  double time_ = 0;
};

std::shared_ptr<const Job> job_of(const ControllerRun& run) {
  const Setup setup = controller_setup(run.settings);
  auto job = std::make_shared<Job>();
  job->program_name = run.program_name;
  job->program = run.program;
  job->machine = setup.machine;
  job->options = setup.options;
  return job;
}

}  // namespace

Cause cause_of(TimeLimit limit) {
  switch (limit) {
    case TimeLimit::feed: return Cause::feed;
    case TimeLimit::rapid: return Cause::rapid;
    case TimeLimit::axis_speed: return Cause::axis_speed;
    case TimeLimit::acceleration: return Cause::acceleration;
    case TimeLimit::corner: return Cause::corner;
    case TimeLimit::buffer:
    case TimeLimit::link: return Cause::lookahead;
    case TimeLimit::stops: return Cause::stop;
    case TimeLimit::dwell: return Cause::dwell;
  }
  return Cause::stop;
}

Result<ControllerOutcome> run_on_controller(const ControllerRun& run, const Monitor& monitor) {
  if (run.settings.controller == Controller::linuxcnc) {
    return tl::unexpected(Error{ErrorKind::input,
                                "controller-blends",
                                "LinuxCNC runs two blocks at a time at corners, which is no motion along the path",
                                "",
                                {},
                                {}});
  }
  PredictOptions options = run.options;
  options.keeps_motion = true;
  auto prediction = predict(*run.program, run.text, run.settings, options, part_of(monitor, 0.0, 0.5));
  if (!prediction) return tl::unexpected(prediction.error());
  ControllerOutcome result{std::move(*prediction), {}};
  Outcome& o = result.outcome;
  o.job = job_of(run);
  o.ran = o.job->options;
  auto path = build_path(run.program->moves, o.job->machine.tool_change, part_of(monitor, 0.5, 0.7));
  if (!path) return tl::unexpected(path.error());
  o.path = std::make_shared<const Path>(std::move(*path));
  auto commands = std::make_shared<const Commands>(command(*o.path, *o.job));
  auto limits =
      limit_speed(*o.path, *commands, o.job->machine, limit_options(o.job->options), part_of(monitor, 0.7, 0.9));
  if (!limits) return tl::unexpected(limits.error());
  o.commands = std::move(commands);
  o.limits = std::move(*limits);
  StageLayer(*o.path, result.prediction.stages, o).run();
  o.summary = summarise(o);
  monitor.report(1.0);
  return result;
}

Result<std::vector<AxisExcess>> axes_over_limits(const Outcome& o, const Monitor& monitor) {
  constexpr double kStepping = 0.01;  // relative: what whole steps and their timer change
  constexpr std::size_t kBatch = 4096;
  std::vector<AxisExcess> worst;
  const auto note = [&](std::size_t axis, AxisExcess::Of of, double value, double limit, std::size_t segment) {
    if (!(value > limit * (1 + kStepping))) return;
    const AxisExcess found{
        axis, of, value, limit, o.job->program->moves.line[o.path->move[segment]], o.node_time[segment]};
    const auto before =
        std::find_if(worst.begin(), worst.end(), [&](const AxisExcess& e) { return e.axis == axis && e.of == of; });
    if (before == worst.end()) {
      worst.push_back(found);
    } else if (value > before->value) {
      *before = found;
    }
  };
  Motion motion(*o.path, o.plan);
  for (std::size_t i = 0; i < o.path->size(); ++i) {
    if (i % kBatch == 0 && monitor.is_cancelled()) return tl::unexpected(cancelled_error());
    for (std::size_t a = 0; a < kAxisCount; ++a) {
      const AxisLimits& limits = o.job->machine.axes[a];
      if (!(limits.speed < kUnlimited) && !(limits.acceleration < kUnlimited)) continue;
      const PhaseBounds b = motion.bounds(o.node_time[i], o.node_time[i + 1], a);
      note(a, AxisExcess::Of::speed, std::max(b.speed.high, -b.speed.low), limits.speed, i);
      note(a, AxisExcess::Of::acceleration, std::max(b.acceleration.high, -b.acceleration.low), limits.acceleration, i);
    }
  }
  std::stable_sort(worst.begin(), worst.end(),
                   [](const AxisExcess& a, const AxisExcess& b) { return a.value * b.limit > b.value * a.limit; });
  return worst;
}

}  // namespace toolpace
