#include "toolpace/rewrite/feeds.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace toolpace::detail::rewrite {
namespace {

constexpr double kCost = 1.01;         // of the time that neighbours may take longer together
constexpr double kUsedLimits = 0.995;  // of the limits: what rounding and the controller's own timing need
constexpr int kPlaces = 32;            // on a half turn, where an arc is asked for its directions
constexpr double kSecondsPerMinute = 60.0;

/// How long a block is, and how fast it may be.
struct Pace {
  double length = 0.0;  // [mm]
  double speed = 0.0;   // [mm/s]
};

class SpanPace {
 public:
  explicit SpanPace(const FeedLimits& limits) : block_time_(limits.block_time) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto axis = static_cast<Eigen::Index>(i);
      speed_[axis] = kUsedLimits * std::min(limits.machine.axes[i].speed, limits.machine.path.speed);
      const double own = limits.machine.axes[i].acceleration;
      acceleration_[axis] = kUsedLimits * (std::isfinite(own) ? own : limits.machine.path.acceleration);
    }
  }

  Pace of_line(const Eigen::Vector3d& way) const {
    const double length = way.norm();
    if (!(length > 0.0)) return {0.0, kUnlimited};
    double speed = in_time(length);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      if (way[axis] != 0.0) speed = std::min(speed, speed_[axis] * length / std::fabs(way[axis]));
    }
    return {length, speed};
  }

  /// @param radius  vector from the centre to the start; @param sweep  [rad] signed about the normal; @param rise  [mm]
  Pace of_arc(const Eigen::Vector3d& radius, const Eigen::Vector3d& normal, double sweep, double rise) const {
    const double r = radius.norm(), flat = r * std::fabs(sweep), length = std::hypot(flat, rise);
    if (!(flat > 0.0)) return of_line(rise * normal);
    const double share = flat / length, bend = share * share / r;
    const Eigen::Vector3d out = radius / r, along = normal.cross(out);
    double speed = in_time(length);
    const int places = std::max(2, static_cast<int>(std::ceil(kPlaces * std::min(std::fabs(sweep), 6.3) / 3.14)));
    for (int k = 0; k <= places; ++k) {
      const double angle = sweep * k / places, c = std::cos(angle), s = std::sin(angle);
      const Eigen::Vector3d towards = c * out + s * along;
      const Eigen::Vector3d going = share * (c * along - s * out) + (rise / length) * normal;
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        if (going[axis] != 0.0) speed = std::min(speed, speed_[axis] / std::fabs(going[axis]));
        if (towards[axis] != 0.0)
          speed = std::min(speed, std::sqrt(acceleration_[axis] / (bend * std::fabs(towards[axis]))));
      }
    }
    return {length, speed};
  }

  /// Of an arc as it was fitted.
  Pace of_fitted(const FittedArc& arc, const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    if (arc.turns == 0) return of_line(to - from);
    const PlaneOfArcs axes(arc.plane);
    Eigen::Vector3d radius = Eigen::Vector3d::Zero();
    radius[axes.first] = -arc.i;
    radius[axes.second] = -arc.j;
    return of_arc(radius, Eigen::Vector3d::Unit(axes.normal), arc.clockwise ? -arc.sweep : arc.sweep,
                  to[axes.normal] - from[axes.normal]);
  }

 private:
  double in_time(double length) const { return block_time_ > 0.0 ? length / block_time_ : kUnlimited; }

  Eigen::Vector3d speed_, acceleration_;
  double block_time_;
};

/// The slower of both, over the length of both; for what stands in one span.
Pace joined(const Pace& a, const Pace& b) { return {a.length + b.length, std::min(a.speed, b.speed)}; }

Pace pace_of(const SpanPace& paces, const Moves& moves, const Run& run, const Span& span) {
  const std::size_t first = run.row + span.first, last = run.row + span.last - 1;
  const Eigen::Vector3d from = moves.begin_of(first).head<3>(), to = moves.end[last].head<3>();
  switch (span.kind) {
    case Span::Kind::line: return paces.of_line(to - from);
    case Span::Kind::arc: return paces.of_fitted(span.arc, from, to);
    case Span::Kind::biarc:
      return joined(paces.of_fitted(span.arc, from, span.joint), paces.of_fitted(span.second, span.joint, to));
    case Span::Kind::kept: break;
  }
  if (moves.kind[first] != MoveKind::arc) return paces.of_line(to - from);
  const ArcDetail& arc = moves.arcs[moves.detail[first]];
  const Eigen::Vector3d normal = arc.normal, off = from - arc.centre;
  return paces.of_arc(off - normal.dot(off) * normal, normal, arc.sweep, normal.dot(to - from));
}

/// Spans that get one feed.
struct Group {
  std::vector<Span*> spans;
  double length = 0.0, least = kUnlimited, time = 0.0;

  bool may_take(const Pace& pace) const {
    const double together = (length + pace.length) / std::min(least, pace.speed);
    return spans.empty() || together <= kCost * (time + pace.length / pace.speed);
  }
  void take(Span& span, const Pace& pace) {
    spans.push_back(&span);
    length += pace.length;
    least = std::min(least, pace.speed);
    time += pace.length / pace.speed;
  }
};

/// Four digits, never more than the value.
double rounded_down(double value) {
  const double step = std::pow(10.0, std::floor(std::log10(value)) - 3);
  return std::floor(value / step) * step;
}

/// Where no feed was lowered, F words stay as they are; where no row was replaced either, all does.
void leave_if_idle(Edit& edit) {
  bool is_lowered = false, is_replaced = false;
  for (const Stretch& stretch : edit.stretches) {
    for (const Span& span : stretch.spans) {
      is_lowered = is_lowered || span.feed > 0.0;
      is_replaced = is_replaced || span.kind != Span::Kind::kept;
    }
  }
  edit.plans_feeds = is_lowered;
  if (!is_lowered && !is_replaced) edit.stretches.clear();
}

}  // namespace

void plan_feeds(const Reading& reading, const FeedLimits& limits, std::vector<Edit>& edits) {
  const SpanPace paces(limits);
  const Moves& moves = reading.moves;
  for (Edit& edit : edits) {
    if (edit.stretches.empty()) continue;
    edit.plans_feeds = true;
    Group group;
    double programmed = 0.0;
    const auto close = [&] {
      for (Span* span : group.spans) {
        span->feed = group.least < programmed ? rounded_down(group.least * kSecondsPerMinute / edit.run.unit) : 0.0;
      }
      group = {};
    };
    for (Stretch& stretch : edit.stretches) {
      for (Span& span : stretch.spans) {
        const double feed = moves.feed[edit.run.row + span.first];
        if (feed != programmed) close();
        programmed = feed;
        const auto modal = reading.modal.at(edit.run.line + span.first);
        span.programmed = modal ? modal->feed : 0.0;
        Pace pace = pace_of(paces, moves, edit.run, span);
        pace.speed = std::min(pace.speed, feed);
        if (!group.may_take(pace)) close();
        group.take(span, pace);
      }
    }
    close();
    leave_if_idle(edit);
  }
}

}  // namespace toolpace::detail::rewrite
