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

class PlanRetimer {
 public:
  PlanRetimer(const Path& path, const Machine& machine, const SpeedLimits& limits, const std::vector<double>& speed,
              const MotionPlan& plan)
      : path_(path),
        machine_(machine),
        limits_(limits),
        speed_(speed),
        plan_(plan),
        node_time_(node_times(limits, plan)),
        position_(node_positions(limits)) {}

  MotionPlan run(const Monitor& monitor) {
    for (std::size_t begin = 0; begin < path_.size();) {
      std::size_t end = begin + 1;
      while (end < path_.size() && limits_.node_cap[end] > 0) ++end;
      if (monitor.is_cancelled()) return {};
      add(begin, end, monitor);
      monitor.report(static_cast<double>(end) / static_cast<double>(path_.size()));
      begin = end;
    }
    return std::move(out_);
  }

 private:
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

  void add(std::size_t begin, std::size_t end, const Monitor& monitor) {
    const std::size_t first = phase_;
    const double from = node_time_[begin], to = node_time_[end];
    while (phase_ < plan_.phases.size() && plan_.phases[phase_].begin + kTimeRounding < to) ++phase_;
    if (may_gain(begin, end)) {
      detail::retime::StretchRetimer retimer({path_, machine_, speed_, begin, end});
      const ArcMotion motion = retimer.run(start(begin, end, first), {monitor.stop, {}});
      if (!motion.empty() && motion.duration() < to - from) {
        add(motion, position_[begin]);
        return;
      }
    }
    for (std::size_t i = first; i < phase_; ++i) {
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
  const std::vector<double>& speed_;
  const MotionPlan& plan_;
  std::vector<double> node_time_, position_;
  std::size_t phase_ = 0;
  double time_ = 0;
  MotionPlan out_;
};

}  // namespace

MotionPlan retime(const Path& path, const Machine& machine, const SpeedLimits& limits, const std::vector<double>& speed,
                  const MotionPlan& plan, const Monitor& monitor) {
  return PlanRetimer(path, machine, limits, speed, plan).run(monitor);
}

}  // namespace toolpace
