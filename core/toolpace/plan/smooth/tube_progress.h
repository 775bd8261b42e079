#pragma once
/// How far along its path a motion through the tube is, at which time.

#include <algorithm>
#include <cmath>
#include <vector>

#include "toolpace/plan/smooth/plan_tube.h"
#include "toolpace/plan/smooth/tube_path.h"

namespace toolpace {

/// Couples a motion with its path: vertices at their passing times, and in between the foot of the motion's point on the
/// segment, which never goes back.
class TubeProgress {
 public:
  TubeProgress(const TubePath& path, const TubeMotion& motion) : path_(path), motion_(motion) {
    const auto axes = static_cast<std::size_t>(path.axes);
    const std::size_t knots = motion.control.size() / axes - 2;
    distance_.reserve(knots);
    std::size_t k = 0;
    double reached = 0;  // on the present segment, 0 … 1
    for (std::size_t i = 0; i < knots; ++i) {
      const double time = static_cast<double>(i) * motion.step;
      for (; k + 1 < path.segments() && motion.pass[k + 1] <= time; ++k) reached = 0;
      reached = std::max(reached, foot(k, i));
      distance_.push_back(path.distance[k] + reached * (path.distance[k + 1] - path.distance[k]));
    }
  }

  /// Path length at knot i, time i·step [mm, deg].
  double at_knot(std::size_t i) const { return distance_[i]; }

  /// Time at which a path length on segment k is reached [s].
  double time_at(std::size_t k, double distance) const {
    double time = motion_.pass[k], at = path_.distance[k];
    for (auto i = static_cast<std::size_t>(time / motion_.step) + 1; i < distance_.size(); ++i) {
      const double next = static_cast<double>(i) * motion_.step;
      if (next >= motion_.pass[k + 1]) break;
      if (distance_[i] >= distance) return between(time, at, next, distance_[i], distance);
      time = next;
      at = std::max(at, distance_[i]);
    }
    return between(time, at, motion_.pass[k + 1], path_.distance[k + 1], distance);
  }

 private:
  static double between(double t0, double d0, double t1, double d1, double d) {
    return d1 > d0 ? t0 + std::clamp((d - d0) / (d1 - d0), 0.0, 1.0) * (t1 - t0) : t1;
  }

  /// Foot of the motion's point at knot i on segment k, 0 … 1.
  double foot(std::size_t k, std::size_t i) const {
    const auto axes = static_cast<std::size_t>(path_.axes);
    const double *c = motion_.control.data() + i * axes, *p = path_.point(k), *q = path_.point(k + 1);
    double along = 0, square = 0;
    for (std::size_t a = 0; a < axes; ++a) {
      const double x = (c[a] + 4 * c[axes + a] + c[2 * axes + a]) / 6, d = q[a] - p[a];
      along += (x - p[a]) * d;
      square += d * d;
    }
    return std::clamp(along / square, 0.0, 1.0);
  }

  const TubePath& path_;
  const TubeMotion& motion_;
  std::vector<double> distance_;
};

}  // namespace toolpace
