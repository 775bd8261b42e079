#include "toolpace/plan/retime/retime.h"

#include <algorithm>
#include <cmath>

#include "toolpace/plan/plan.h"
#include "toolpace/plan/retime/stretch_retimer.h"

namespace toolpace {
namespace {

using detail::retime::ArcMotion;

/// Longer stretches stay as they are, so that memory is bounded [s].
constexpr double kLongest = 1000;
/// A stretch that takes no longer than this multiple of what its feed commands has nothing to gain.
constexpr double kWorthwhile = 1.002;
constexpr double kTimeRounding = 1e-9;  // [s]
constexpr std::size_t kBatch = 64;      // stretches that are timed before they are written

class PlanRetimer {
 public:
  PlanRetimer(const Path& path, const Commands& commands, const Machine& machine, const SpeedLimits& limits,
              const MotionPlan& plan)
      : path_(path),
        machine_(machine),
        limits_(limits),
        plan_(plan),
        node_time_(node_times(limits, plan)),
        position_(node_positions(limits)) {
    // The caps of curves are what is to be beaten; on lines they are what is commanded and what the axes can do.
    speed_.reserve(path.size());
    for (std::size_t i = 0; i < path.size(); ++i) {
      speed_.push_back(path.kind[i] == SegmentKind::line ? limits.block_cap[i] : commands[i].speed);
    }
  }

  MotionPlan run(const ForEach& for_each, const Monitor& monitor) {
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
    return std::move(out_);
  }

 private:
  /// From one rest to the next.
  struct Stretch {
    std::size_t begin, end;              ///< segments
    std::size_t first_phase, end_phase;  ///< of the plan
    ArcMotion motion = {};               ///< empty where the plan's own stays
  };

  Stretch stretch_from(std::size_t begin) {
    std::size_t end = begin + 1;
    while (end < path_.size() && limits_.node_cap[end] > 0) ++end;
    const std::size_t first = phase_;
    while (phase_ < plan_.phases.size() && plan_.phases[phase_].begin + kTimeRounding < node_time_[end]) ++phase_;
    return {begin, end, first, phase_};
  }

  void time_anew(Stretch& s, const Monitor& monitor) const {
    if (!may_gain(s.begin, s.end)) return;
    detail::retime::StretchRetimer retimer({path_, machine_, speed_, s.begin, s.end});
    ArcMotion motion = retimer.run(start(s.begin, s.end, s.first_phase), {monitor.stop, {}});
    if (!motion.empty() && motion.duration() < node_time_[s.end] - node_time_[s.begin]) s.motion = std::move(motion);
  }

  /// Lines alone are run as fast as they can be; speed steps at corners are the corner rule's. Every moving axis of X, Y, Z
  /// has to be limited.
  bool may_gain(std::size_t begin, std::size_t end) const {
    bool is_curved = false;
    double least = 0;
    for (std::size_t i = begin; i < end; ++i) {
      is_curved |= path_.kind[i] != SegmentKind::line;
      least += path_.length[i] / speed_[i];
      if (is_rotary_only(path_, i)) return false;
      if (i > begin && limits_.node_cap[i] < std::min(limits_.block_cap[i - 1], limits_.block_cap[i])) return false;
    }
    const double duration = node_time_[end] - node_time_[begin];
    if (!is_curved || duration <= kWorthwhile * least || !(duration <= kLongest)) return false;
    for (std::size_t a = 0; a < 3; ++a) {
      const AxisLimits& axis = machine_.axes[a];
      if ((axis.acceleration < kUnlimited && axis.jerk < kUnlimited) || !moves(a, begin, end)) continue;
      return false;
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
    if (!s.motion.empty()) return add(s.motion, position_[s.begin]);
    const double from = node_time_[s.begin], to = node_time_[s.end];
    for (std::size_t i = s.first_phase; i < s.end_phase; ++i) {
      out_.phases.push_back(plan_.phases[i]);
      out_.phases.back().begin = time_ + (plan_.phases[i].begin - from);
    }
    time_ += to - from;
  }

  void add(const ArcMotion& motion, double position) {
    for (std::size_t k = 0; k < motion.intervals(); ++k) {
      const ArcMotion::State& s = motion.knot(k);
      out_.phases.push_back(
          {time_, motion.step(k), position + s.distance, s.speed, s.acceleration, s.jerk, PhaseShape::constant_jerk});
      time_ += motion.step(k);
    }
  }

  /// The plan's own motion, on knots.
  ArcMotion start(std::size_t begin, std::size_t end, std::size_t phase) const {
    using detail::retime::kInterval;
    const double from = node_time_[begin], duration = node_time_[end] - from;
    const auto n = std::max(detail::retime::kLeastIntervals, static_cast<std::size_t>(std::ceil(duration / kInterval)));
    const double step = duration / static_cast<double>(n), length = position_[end] - position_[begin];
    std::vector<double> position(n + 1);
    for (std::size_t k = 0; k <= n; ++k) {
      const double t = from + static_cast<double>(k) * step;
      while (phase + 1 < plan_.phases.size() && plan_.phases[phase + 1].begin <= t) ++phase;
      const Phase& p = plan_.phases[phase];
      const double at = evaluate(p, std::clamp(t - p.begin, 0.0, p.duration)).distance - position_[begin];
      position[k] = std::clamp(at, k > 0 ? position[k - 1] : 0.0, length);
    }
    position.front() = 0;
    position.back() = length;
    return {position, step};
  }

  const Path& path_;
  const Machine& machine_;
  const SpeedLimits& limits_;
  std::vector<double> speed_;  // at most, of each segment, curvature aside
  const MotionPlan& plan_;
  std::vector<double> node_time_, position_;
  std::size_t phase_ = 0;
  double time_ = 0;
  MotionPlan out_;
};

}  // namespace

MotionPlan retime(const Path& path, const Commands& commands, const Machine& machine, const SpeedLimits& limits,
                  const MotionPlan& plan, const ForEach& for_each, const Monitor& monitor) {
  return PlanRetimer(path, commands, machine, limits, plan).run(for_each, monitor);
}

}  // namespace toolpace
