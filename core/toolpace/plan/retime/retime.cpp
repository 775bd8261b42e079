#include "toolpace/plan/retime/retime.h"

#include <algorithm>
#include <cmath>

#include "toolpace/law/law_table.h"
#include "toolpace/limits/ceilings.h"
#include "toolpace/limits/curve_axes.h"
#include "toolpace/plan/plan.h"
#include "toolpace/plan/retime/stretch_retimer.h"

namespace toolpace {
namespace {

using detail::retime::ArcMotion;

/// Longer stretches stay as they are, so that memory is bounded [s].
constexpr double kLongest = 1000;
/// A stretch that takes no longer than this multiple of what its feed commands, or whose curves do not, has nothing to gain.
constexpr double kWorthwhile = 1.003;
constexpr double kAtRest = 1e-6;        // of a phase's acceleration
constexpr double kTimeRounding = 1e-9;  // [s]
constexpr std::size_t kBatch = 64;      // stretches that are timed before they are written

class PlanRetimer {
 public:
  PlanRetimer(const RetimeTask& task, const MotionPlan& plan, const MotionPlan& start)
      : path_(task.path),
        limits_(task.limits),
        keeps_jerk_(law_row(task.options.law).bounds_jerk),
        task_(task),
        top_speed_(task.commands.top_speed()),
        plan_(plan),
        start_(start),
        node_time_(node_times(task.limits, plan)),
        start_time_(node_times(task.limits, start)),
        position_(node_positions(task.limits)) {
    // The caps of curves are what is to be beaten; on lines they are what is commanded and what the axes can do.
    speed_.reserve(path_.size());
    for (std::size_t i = 0; i < path_.size(); ++i) {
      speed_.push_back(path_.kind[i] == SegmentKind::line ? limits_.block_cap[i] : task.commands[i].speed);
    }
    corner_.assign(path_.size() + 1, kUnlimited);
    for (std::size_t i = 1; i < path_.size(); ++i) {
      if (limits_.node_cap[i] < std::min(limits_.block_cap[i - 1], limits_.block_cap[i]))
        corner_[i] = limits_.node_cap[i];
    }
    for (const SpeedLimits::Corner& corner : limits_.corners) corner_[corner.node] = corner.speed;
  }

  std::optional<MotionPlan> run(const ForEach& for_each, const Monitor& monitor) {
    for (std::size_t begin = 0; begin < path_.size();) {
      std::vector<Stretch> batch;
      for (; begin < path_.size() && batch.size() < kBatch; begin = batch.back().end)
        batch.push_back(stretch_from(begin));
      for_each(batch.size(), [&](std::size_t i) {
        if (!monitor.is_cancelled()) time_anew(batch[i], monitor);
      });
      if (monitor.is_cancelled()) return {};
      for (const Stretch& s : batch) add(s);
      monitor.report(static_cast<double>(begin) / static_cast<double>(path_.size()));
    }
    if (!is_faster_) return {};
    return std::move(out_);
  }

 private:
  /// What holds in a stretch.
  struct Rules {
    std::array<AxisLimits, kAxisCount> axes;
    detail::retime::AlongLimits along;  ///< whatever turns
  };

  /// Where the program changes its limits on the way, the lowest of them hold in all of the stretch.
  Rules rules_of(std::size_t begin, std::size_t end) const {
    const Machine machine = under(task_.machine, lowest_ceiling(task_.commands, begin, end));
    const RampLimits along = ramps_timed_anew(task_.options, top_speed_, machine.path);
    return {curve_axes(machine, keeps_jerk_), {along.acceleration, along.jerk}};
  }

  /// From one rest to the next.
  struct Stretch {
    std::size_t begin, end;              ///< segments
    std::size_t first_phase, end_phase;  ///< of the plan
    std::size_t first_start;             ///< phase of the start
    ArcMotion motion = {};               ///< empty where the plan's own stays
  };

  Stretch stretch_from(std::size_t begin) {
    std::size_t end = begin + 1;
    while (end < path_.size() && limits_.node_cap[end] > 0) ++end;
    const std::size_t first = phase_;
    while (phase_ < plan_.phases.size() && plan_.phases[phase_].begin + kTimeRounding < node_time_[end]) ++phase_;
    const std::size_t first_start = start_phase_;
    while (start_phase_ < start_.phases.size() &&
           start_.phases[start_phase_].begin + kTimeRounding < start_time_[end]) {
      ++start_phase_;
    }
    return {begin, end, first, phase_, first_start};
  }

  void time_anew(Stretch& s, const Monitor& monitor) const {
    const Rules rules = rules_of(s.begin, s.end);
    if (turns_back(s) || !may_gain(s.begin, s.end, rules.axes)) return;
    const double begin = start_time_[s.begin];
    const detail::retime::PlanPart start{start_.phases, s.first_start, begin, start_time_[s.end] - begin,
                                         position_,     s.begin,       s.end};
    detail::retime::StretchRetimer retimer({path_, rules.axes, rules.along, speed_, corner_, s.begin, s.end});
    ArcMotion motion = retimer.run(motion_of(start), {monitor.stop, {}});
    if (!motion.empty() && motion.duration() < node_time_[s.end] - node_time_[s.begin]) s.motion = std::move(motion);
  }

  /// Whether it begins or ends at a reversal with acceleration, which its neighbour shares.
  bool turns_back(const Stretch& s) const {
    if (s.first_phase == s.end_phase) return false;
    const Phase &first = plan_.phases[s.first_phase], &last = plan_.phases[s.end_phase - 1];
    return first.acceleration != 0 || std::abs(evaluate(last, last.duration).acceleration) > kAtRest * peak(last);
  }

  static double peak(const Phase& p) {
    const PhaseExtrema e = extrema(p);
    return std::max(e.max_acceleration, e.max_deceleration);
  }

  /// Lines alone are run as fast as they can be. Every moving axis of X, Y, Z has to be limited.
  bool may_gain(std::size_t begin, std::size_t end, const std::array<AxisLimits, kAxisCount>& axes) const {
    double least = 0, curves = 0, least_curves = 0;
    for (std::size_t i = begin; i < end; ++i) {
      if (is_rotary_only(path_, i)) return false;
      const double commanded = path_.length[i] / speed_[i];
      least += commanded;
      if (path_.kind[i] == SegmentKind::line) continue;
      least_curves += commanded;
      curves += node_time_[i + 1] - node_time_[i];
    }
    const double duration = node_time_[end] - node_time_[begin];
    if (!(duration > kWorthwhile * least) || !(curves > kWorthwhile * least_curves) || !(duration <= kLongest))
      return false;
    for (std::size_t a = 0; a < 3; ++a) {
      const bool is_limited = axes[a].acceleration < kUnlimited && (!keeps_jerk_ || axes[a].jerk < kUnlimited);
      if (!is_limited && moves(a, begin, end)) return false;
    }
    return true;
  }

  bool moves(std::size_t axis, std::size_t begin, std::size_t end) const {
    const auto a = static_cast<Eigen::Index>(axis);
    for (std::size_t i = begin; i < end; ++i) {
      if (path_.node[i][a] != path_.node[i + 1][a] || (path_.kind[i] == SegmentKind::arc)) return true;
    }
    return false;
  }

  void add(const Stretch& s) {
    if (!s.motion.empty()) {
      is_faster_ = true;
      return add(s.motion, s.begin);
    }
    const double from = node_time_[s.begin], to = node_time_[s.end];
    for (std::size_t i = s.first_phase; i < s.end_phase; ++i) {
      out_.phases.push_back(plan_.phases[i]);
      out_.phases.back().begin = time_ + (plan_.phases[i].begin - from);
    }
    time_ += to - from;
  }

  void add(const ArcMotion& motion, std::size_t node) {
    for (std::size_t k = 0; k < motion.intervals(); ++k) {
      const ArcMotion::State& s = motion.knot(k);
      out_.phases.push_back({time_, motion.step(k), s.distance, s.speed, s.acceleration, s.jerk,
                             PhaseShape::constant_jerk, static_cast<std::uint32_t>(node)});
      time_ += motion.step(k);
    }
  }

  const Path& path_;
  const SpeedLimits& limits_;
  bool keeps_jerk_;
  const RetimeTask& task_;
  double top_speed_;            // commanded anywhere
  std::vector<double> speed_;   // at most, of each segment, curvature aside
  std::vector<double> corner_;  // at most, of each node; infinite where only its segments hold it down
  const MotionPlan &plan_, &start_;
  std::vector<double> node_time_, start_time_;
  NodePositions position_;
  std::size_t phase_ = 0, start_phase_ = 0;
  double time_ = 0;
  bool is_faster_ = false;
  MotionPlan out_;
};

}  // namespace

RampLimits ramps_timed_anew(const PlanOptions& options, double top_speed, const PathLimits& path) {
  const LawRow& law = law_row(options.law);
  RampLimits ramps{std::min(path.acceleration, path.deceleration), std::min(path.jerk, path.jerk_deceleration)};
  if (!law.bounds_jerk) ramps.jerk = kUnlimited;
  const double least = law.uses_time ? std::max(options.t_acc, options.t_dec) : 0.0;
  if (!(least > 0)) return ramps;
  ramps.acceleration = std::min(ramps.acceleration, 2 * top_speed / least);
  ramps.jerk = std::min(ramps.jerk, 4 * top_speed / (least * least));
  return ramps;
}

std::optional<MotionPlan> retime(const RetimeTask& task, const MotionPlan& plan, const MotionPlan& start,
                                 const ForEach& for_each, const Monitor& monitor) {
  return PlanRetimer(task, plan, start).run(for_each, monitor);
}

}  // namespace toolpace
