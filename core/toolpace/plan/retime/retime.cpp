#include "toolpace/plan/retime/retime.h"

#include <algorithm>
#include <cmath>

#include "toolpace/law/law_table.h"
#include "toolpace/limits/ceilings.h"
#include "toolpace/limits/curve_axes.h"
#include "toolpace/path/axis_curve.h"
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
/// What runs at its commanded speed for so long has nothing to gain there, but for a while at both its ends [s].
constexpr double kLongCruise = 0.4, kNearChange = 0.1;
constexpr double kSameSpeed = 1e-9;  // relative
constexpr double kBrief = 10;        // stretches of no more are timed as a whole [s]

class PlanRetimer {
 public:
  PlanRetimer(const RetimeTask& task, const MotionPlan& plan, const MotionPlan& start)
      : path_(task.path),
        curve_(task.path),
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
      speed_.push_back(curve_.is_straight(i) ? limits_.block_cap[i] : task.commands[i].speed);
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

  /// Where both plans rest or run at the same constant speed.
  struct Place {
    std::size_t segment;
    double offset;      ///< from where the segment begins [mm]
    double speed;       ///< [mm/s]
    std::size_t phase;  ///< of the plan
    double time;        ///< in the plan [s]
    std::size_t start_phase;
    double start_time;  ///< in the start
  };

  /// What is timed by itself.
  struct Part {
    Place from, to;
    ArcMotion motion = {};  ///< empty where the plan's own stays

    double duration() const { return to.time - from.time; }
    /// One behind the last segment.
    std::size_t end() const { return to.offset > 0 ? to.segment + 1 : to.segment; }
  };

  /// From one rest to the next, in parts: what is run at the commanded speed for long, and what lies between.
  struct Stretch {
    std::size_t begin, end;              ///< segments
    std::size_t first_phase, end_phase;  ///< of the plan
    std::vector<Part> parts;
  };

  Stretch stretch_from(std::size_t begin) {
    std::size_t end = begin + 1;
    while (end < path_.size() && limits_.node_cap[end] > 0) ++end;
    Place from = rest_at(begin);
    Stretch s{begin, end, phase_, phase_, {}};
    while (phase_ < plan_.phases.size() && plan_.phases[phase_].begin + kTimeRounding < node_time_[end]) ++phase_;
    s.end_phase = phase_;
    for (const auto& [cruise, changes] : cruises(s)) {
      s.parts.push_back({from, cruise});
      s.parts.push_back({cruise, changes});
      from = changes;
    }
    while (start_phase_ < start_.phases.size() &&
           start_.phases[start_phase_].begin + kTimeRounding < start_time_[end]) {
      ++start_phase_;
    }
    s.parts.push_back({from, rest_at(end)});
    return s;
  }

  Place rest_at(std::size_t node) const {
    return {node, 0.0, 0.0, phase_, node_time_[node], start_phase_, start_time_[node]};
  }

  /// Begins and ends of what is run at the commanded speed for long, by both plans. None in brief stretches.
  std::vector<std::pair<Place, Place>> cruises(const Stretch& s) {
    std::vector<std::pair<Place, Place>> found;
    if (!(node_time_[s.end] - node_time_[s.begin] > kBrief)) return found;
    std::size_t segment = s.begin;
    for (std::size_t i = s.first_phase, next; i < s.end_phase; i = next) {
      const Phase& first = plan_.phases[i];
      for (next = i + 1; next < s.end_phase && is_cruise(first) && cruises_at(plan_.phases[next], first.speed);) ++next;
      const Phase& last = plan_.phases[next - 1];
      const double begin = first.begin + kNearChange, end = last.begin + last.duration - kNearChange;
      if (!is_cruise(first) || !(end - begin > kLongCruise - 2 * kNearChange)) continue;
      const auto from = cruising_at(begin, i, s, segment), to = cruising_at(end, i, s, segment);
      if (from && to && is_commanded(first.speed, from->segment, to->segment)) found.emplace_back(*from, *to);
    }
    return found;
  }

  static bool is_cruise(const Phase& p) {
    return p.shape == PhaseShape::constant_jerk && p.acceleration == 0 && p.rate == 0 && p.speed > 0;
  }

  static bool cruises_at(const Phase& p, double speed) {
    return is_cruise(p) && std::abs(p.speed - speed) <= kSameSpeed * speed;
  }

  bool is_commanded(double speed, std::size_t first, std::size_t last) const {
    return std::all_of(speed_.begin() + static_cast<std::ptrdiff_t>(first),
                       speed_.begin() + static_cast<std::ptrdiff_t>(last) + 1,
                       [speed](double most) { return most <= speed * (1 + kSameSpeed); });
  }

  /// The place at a time while the plan cruises; nothing where the start does not, at the same speed. Goes forward only.
  /// @param phase    of the plan, at the time or before
  /// @param segment  at the place or before; in the end, there
  std::optional<Place> cruising_at(double time, std::size_t phase, const Stretch& s, std::size_t& segment) {
    while (phase + 1 < s.end_phase && plan_.phases[phase + 1].begin <= time) ++phase;
    const Phase& p = plan_.phases[phase];
    const auto offset_in = [&](std::size_t i) {
      return position_.between(i, p.node) + p.distance + p.speed * (time - p.begin);
    };
    while (segment + 1 < s.end && offset_in(segment + 1) >= 0) ++segment;
    const double offset = std::clamp(offset_in(segment), 0.0, path_.length[segment]);
    const auto begins_at = [&](const Phase& q) { return position_.between(segment, q.node) + q.distance; };
    while (start_phase_ + 1 < start_.phases.size() && begins_at(start_.phases[start_phase_ + 1]) <= offset) {
      ++start_phase_;
    }
    const Phase& q = start_.phases[start_phase_];
    if (!cruises_at(q, p.speed)) return {};
    const double start_time = q.begin + std::clamp((offset - begins_at(q)) / q.speed, 0.0, q.duration);
    return Place{segment, offset, p.speed, phase, time, start_phase_, start_time};
  }

  void time_anew(Stretch& s, const Monitor& monitor) const {
    if (turns_back(s) || !has_slow_curves(s)) return;
    const Rules rules = rules_of(s.begin, s.end);
    for (Part& part : s.parts) {
      if (may_gain(part, rules.axes)) time_anew(part, rules, monitor);
    }
  }

  void time_anew(Part& part, const Rules& rules, const Monitor& monitor) const {
    const Place &from = part.from, &to = part.to;
    const detail::retime::PlanPart start{start_.phases,
                                         from.start_phase,
                                         from.start_time,
                                         to.start_time - from.start_time,
                                         position_,
                                         from.segment,
                                         from.offset,
                                         position_.between(from.segment, to.segment) + to.offset,
                                         {from.speed, to.speed}};
    detail::retime::StretchRetimer retimer({path_, rules.axes, rules.along, speed_, corner_, from.segment, part.end()});
    ArcMotion motion = retimer.run(motion_of(start), {monitor.stop, {}});
    if (!motion.empty() && motion.duration() < part.duration()) part.motion = std::move(motion);
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

  /// Stretches of lines are left to the law.
  bool has_slow_curves(const Stretch& s) const {
    double commanded = 0, planned = 0;
    for (std::size_t i = s.begin; i < s.end; ++i) {
      if (curve_.is_straight(i)) continue;
      commanded += path_.length[i] / speed_[i];
      planned += node_time_[i + 1] - node_time_[i];
    }
    return planned > kWorthwhile * commanded;
  }

  /// Every moving axis of X, Y, Z has to be limited.
  bool may_gain(const Part& part, const std::array<AxisLimits, kAxisCount>& axes) const {
    const Place &from = part.from, &to = part.to;
    double least = 0;
    for (std::size_t i = from.segment; i < part.end(); ++i) {
      if (is_rotary_only(path_, i)) return false;
      const double begin = i == from.segment ? from.offset : 0.0, end = i == to.segment ? to.offset : path_.length[i];
      least += (end - begin) / speed_[i];
    }
    if (!(part.duration() > kWorthwhile * least) || !(part.duration() <= kLongest)) return false;
    for (std::size_t a = 0; a < 3; ++a) {
      const bool is_limited = axes[a].acceleration < kUnlimited && (!keeps_jerk_ || axes[a].jerk < kUnlimited);
      if (!is_limited && moves(a, from.segment, part.end())) return false;
    }
    return true;
  }

  bool moves(std::size_t axis, std::size_t begin, std::size_t end) const {
    const auto a = static_cast<Eigen::Index>(axis);
    for (std::size_t i = begin; i < end; ++i) {
      if (path_.node[i][a] != path_.node[i + 1][a] || path_.kind[i] == SegmentKind::arc || !curve_.is_path(i))
        return true;
    }
    return false;
  }

  void add(const Stretch& s) {
    for (const Part& part : s.parts) {
      if (part.motion.empty()) {
        add_own(part, s.end_phase);
        continue;
      }
      is_faster_ = true;
      add(part.motion, part.from.segment);
    }
  }

  /// The plan's own phases; those that reach beyond the part are constant speed there.
  void add_own(const Part& part, std::size_t end_phase) {
    const double from = part.from.time, to = part.to.time;
    for (std::size_t i = part.from.phase; i < end_phase && plan_.phases[i].begin + kTimeRounding < to; ++i) {
      Phase p = plan_.phases[i];
      const double before = part.from.speed > 0 ? std::max(0.0, from - p.begin) : 0.0;
      const double behind = part.to.speed > 0 ? std::max(0.0, p.begin + p.duration - to) : 0.0;
      p.distance += p.speed * before;
      p.duration -= before + behind;
      p.begin = time_ + (p.begin + before - from);
      out_.phases.push_back(p);
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
  AxisCurve curve_;
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
