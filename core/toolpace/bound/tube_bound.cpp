#include "toolpace/bound/tube_bound.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "toolpace/bound/path_bound.h"

namespace toolpace {
namespace {

constexpr std::size_t kLinearAxes = 3;
constexpr double kArcStep = 0.1;           ///< [rad] between the points that may be chosen on a curve
constexpr std::size_t kPointsBefore = 32;  ///< of which the best one is looked for

using Point = Eigen::Vector3d;

double distance(const Point& a, const Point& b) { return (b - a).norm(); }

Point xyz(const AxisVector& v) { return v.head<3>(); }

class TubeBound {
 public:
  TubeBound(const Path& path, const Commands& commands, const Machine& machine, double tolerance)
      : path_(path), commands_(commands), machine_(machine) {
    std::array<bool, kLinearAxes> moved{};
    for (const AxisVector& node : path.node) {
      for (std::size_t k = 0; k < kLinearAxes; ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        moved[k] = moved[k] || node[i] != path.node.front()[i];
      }
    }
    for (const SegmentKind kind : path.kind) moved_round_ = moved_round_ || kind != SegmentKind::line;
    Point speed = Point::Zero(), acceleration = Point::Zero();
    for (std::size_t k = 0; k < kLinearAxes; ++k) {
      if (!moved[k] && !moved_round_) continue;
      const auto i = static_cast<Eigen::Index>(k);
      speed[i] = machine.axes[k].speed;
      acceleration[i] = machine.axes[k].acceleration;
    }
    speed_ = std::min(machine.path.speed, speed.norm());
    up_ = std::min(machine.path.acceleration, acceleration.norm());
    down_ = std::min(machine.path.deceleration, acceleration.norm());
    // Between two setpoints the motion is off their chord by no more than a·Ts²/8.
    const double bulge = acceleration.norm() * machine.period * machine.period / 8;
    radius_ = tolerance + (std::isfinite(bulge) ? bulge : 0.0);
  }

  /// The points of the longest time, as far as they are no more than kPointsBefore apart of those that may be chosen.
  double with_best_points() {
    is_chosen_at_end_ = true;
    return with_points_apart(1);
  }

  double with_points_apart(double multiple) {
    least_distance_ = multiple * radius_;
    time_ = 0;
    start_section(xyz(path_.node.front()));
    auto pause = path_.pauses.begin();
    for (std::size_t i = 0; i < path_.size(); ++i) {
      for (; pause != path_.pauses.end() && pause->node < i; ++pause) continue;
      if (pause != path_.pauses.end() && pause->node == i) {
        end_section(xyz(i > 0 ? path_.end_of(i - 1) : path_.node[i]));
        if (!path_.tellings.empty()) start_section(xyz(path_.node[i]));
      }
      walk(i);
    }
    end_section(xyz(path_.node.back()));
    return time_;
  }

 private:
  /// Rapids may cut a corner in a direction in which the axes together are faster than in either of its own.
  double top_speed(std::size_t segment) const {
    const Command& command = commands_[segment];
    return command.is_rapid ? speed_ : std::min(speed_, command.speed);
  }

  void walk(std::size_t segment) {
    if (is_rotary_only(path_, segment)) return;
    cap_ = std::max(cap_, top_speed(segment));
    const double length = path_.length[segment];
    if (path_.kind[segment] != SegmentKind::line) {
      const double curvature = xyz(frame_at(path_, segment, length / 2).second).norm();
      const double pieces = std::min(1e4, std::floor(length * curvature / kArcStep));
      for (double k = 1; k < pieces; ++k) {
        take(xyz(point_at(path_, segment, length * k / pieces)));
        cap_ = std::max(cap_, top_speed(segment));
      }
    }
    take(xyz(path_.end_of(segment)));
  }

  /// Chooses the point, if it is far enough from the one before.
  void take(const Point& point) {
    if (distance(last_, point) < least_distance_) return;
    is_chosen_at_end_ ? keep(point) : choose(point);
  }

  void keep(const Point& point) {
    kept_.push_back({point, cap_, 0, 0});
    last_ = point;
    cap_ = 0;
  }

  double time_between(const Point& from, const Point& to, double cap) const {
    const double length = distance(from, to) - 2 * radius_;
    double time = cap > 0 && length > 0 ? length / cap : 0.0;
    for (std::size_t k = 0; k < kLinearAxes; ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      time = std::max(time, (std::abs(to[i] - from[i]) - 2 * radius_) / machine_.axes[k].speed);
    }
    return time;
  }

  void choose_best() {
    for (std::size_t to = 1; to < kept_.size(); ++to) {
      double cap = kept_[to].cap, most = -1;
      for (std::size_t from = to; from-- > 0 && to - from <= kPointsBefore;) {
        const double time = kept_[from].time + std::max(0.0, time_between(kept_[from].point, kept_[to].point, cap));
        cap = std::max(cap, kept_[from].cap);
        if (time <= most) continue;
        most = time;
        kept_[to].from = from;
      }
      kept_[to].time = most;
    }
    std::vector<std::size_t> chosen;
    for (std::size_t i = kept_.size() - 1; i > 0; i = kept_[i].from) chosen.push_back(i);
    last_ = kept_.front().point;
    std::size_t from = 0;
    for (; !chosen.empty(); chosen.pop_back()) {
      for (cap_ = 0; from < chosen.back();) cap_ = std::max(cap_, kept_[++from].cap);
      choose(kept_[from].point);
    }
  }

  void choose(const Point& point) {
    const double length = distance(last_, point) - 2 * radius_;
    section_time_ += std::max(0.0, time_between(last_, point, cap_));
    if (length > 0 && cap_ > 0 && cap_ < kUnlimited) {
      line_.length.push_back(length);
      line_.block_cap.push_back(cap_);
    }
    last_ = point;
    cap_ = 0;
  }

  void start_section(const Point& point) {
    last_ = point;
    cap_ = 0;
    section_time_ = 0;
    line_ = {};
    kept_.assign(1, {point, 0, 0, 0});
  }

  /// The machine rests at the point.
  void end_section(const Point& point) {
    if (is_chosen_at_end_) {
      keep(point);
      choose_best();
    } else {
      choose(point);
    }
    time_ += std::max(section_time_, line_time());
    start_section(point);
  }

  /// The fastest motion from rest to rest along a line of the section's lengths.
  double line_time() {
    const std::size_t n = line_.length.size();
    if (n == 0 || !(up_ < kUnlimited) || !(down_ < kUnlimited)) return 0;
    line_.ramp.assign(n, 0);
    line_.node_cap.assign(n + 1, 0.0);
    for (std::size_t i = 1; i < n; ++i) line_.node_cap[i] = std::min(line_.block_cap[i - 1], line_.block_cap[i]);
    line_.dynamics = {{{up_, kUnlimited, 0.0}, {down_, kUnlimited, 0.0}}};
    return path_bound(line_, LawKind::trapezoid);
  }

  const Path& path_;
  const Commands& commands_;
  const Machine& machine_;
  bool moved_round_ = false;
  double speed_, up_, down_;  ///< of any motion along the axes that move [mm/s, mm/s²]
  double radius_;             ///< of the tube [mm]
  double least_distance_ = 0;

  Point last_ = Point::Zero();  ///< point chosen last
  double cap_ = 0;              ///< top speed since then
  double section_time_ = 0, time_ = 0;
  SpeedLimits line_;

  struct Kept {
    Point point;
    double cap;        ///< top speed since the one before
    double time;       ///< the most from the section's begin on
    std::size_t from;  ///< the one chosen before it, for that
  };
  bool is_chosen_at_end_ = false;
  std::vector<Kept> kept_;  ///< of the section
};

}  // namespace

double tube_bound(const Path& path, const Commands& commands, const Machine& machine, double tolerance) {
  if (path.size() == 0) return 0;
  TubeBound bound(path, commands, machine, tolerance);
  double longest = 0;
  for (const double multiple : {25.0, 100.0, 400.0}) longest = std::max(longest, bound.with_points_apart(multiple));
  return std::max(longest, bound.with_best_points());
}

}  // namespace toolpace
