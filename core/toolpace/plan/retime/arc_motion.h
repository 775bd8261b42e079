#pragma once
/// A motion along a path as a cubic B-spline in time: jerk is constant between knots.

#include <algorithm>
#include <cmath>
#include <vector>

#include "toolpace/law/phase.h"
#include "toolpace/path/node_positions.h"

namespace toolpace::detail::retime {

/// At its ends at rest or at constant speed: the first three control points are as far apart as each other, and the last three.
class ArcMotion {
 public:
  struct State {
    double distance, speed, acceleration;  ///< [mm, mm/s, mm/s²]
    double jerk;                           ///< from here on [mm/s³]
  };

  /// [mm/s] ≥ 0
  struct EndSpeeds {
    double begin = 0, end = 0;
  };

  ArcMotion() = default;

  /// The motion whose positions at uniform knots are close to `position`: smoothed a little, but at the ends, where cubic
  /// polynomials are kept exactly. No limit that the given positions keep in their differences is passed.
  /// @param position  of each knot [mm], at least four, not falling
  /// @param ends      speeds at the begin and the end
  ArcMotion(const std::vector<double>& position, double step, EndSpeeds ends)
      : ends_(ends), step_(position.size() - 1, step) {
    const std::size_t n = step_.size();
    control_.resize(n + 3);
    const double begin = position.front(), end = position.back();
    for (std::size_t k = 0; k <= n; ++k) {
      const double before = k > 0 ? position[k - 1] : begin, after = k < n ? position[k + 1] : end;
      const double near = static_cast<double>(std::min(k, n - k));
      const double x = std::clamp((near - kExactEnd) / kExactFade, 0.0, 1.0);
      const double exact = (1 - x) * (1 - x) * (1 + 2 * x);
      control_[k + 1] = position[k] - exact * (after - 2 * position[k] + before) / 6;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const double from_end = (static_cast<double>(k) - 1) * step;
      control_[k] = begin + from_end * ends.begin;
      control_[n + 2 - k] = end - from_end * ends.end;
    }
    for (std::size_t k = 1; k < control_.size(); ++k) {
      control_[k] = std::min(std::max(control_[k], control_[k - 1]), control_.back());
    }
    find_states();
  }

  bool empty() const { return step_.empty(); }
  const EndSpeeds& ends() const { return ends_; }
  std::size_t intervals() const { return step_.size(); }
  double step(std::size_t k) const { return step_[k]; }
  double duration() const {
    double sum = 0;
    for (const double h : step_) sum += h;
    return sum;
  }

  /// At the beginning of interval k.
  const State& knot(std::size_t k) const { return state_[k]; }

  /// At share x of interval k.
  State at(std::size_t k, double x) const {
    const State& s = state_[k];
    const double t = x * step_[k];
    return {s.distance + t * (s.speed + t * (s.acceleration / 2 + t * s.jerk / 6)),
            s.speed + t * (s.acceleration + t * s.jerk / 2), s.acceleration + t * s.jerk, s.jerk};
  }

  /// The share, from `low` on, at which interval k is at a distance that it passes. To rounding, by bisection and Newton.
  double share_at(std::size_t k, double distance, double low) const {
    double high = 1.0, x = low;
    for (int i = 0; i < 60 && high - low > 1e-15; ++i) {
      const State s = at(k, x);
      (s.distance < distance ? low : high) = x;
      const double newton = s.speed > 0 ? x + (distance - s.distance) / (s.speed * step_[k]) : low;
      const double next = newton > low && newton < high ? newton : (low + high) / 2;
      if (std::abs(next - x) <= 1e-15) return next;
      x = next;
    }
    return x;
  }

  /// Stretches each interval; neighbours should differ little.
  void stretch(const std::vector<double>& factor) {
    for (std::size_t k = 0; k < step_.size(); ++k) step_[k] *= factor[k];
    find_states();
  }

 private:
  static constexpr double kExactEnd = 4, kExactFade = 24;  // [knots]

  /// Derivatives of the control polygon; the position at a knot from its control point, which is the blossom of the knots
  /// around it.
  void find_states() {
    const std::size_t n = step_.size();
    const auto h = [&](std::size_t k) { return step_[std::min(std::max<std::size_t>(k, 2) - 2, n - 1)]; };  // of k − 2
    const auto first = [&](std::size_t j) {
      return 3 * (control_[j + 1] - control_[j]) / (h(j) + h(j + 1) + h(j + 2));
    };
    state_.resize(n + 1);
    double d = first(0);
    for (std::size_t k = 0; k <= n; ++k) {
      const double before = h(k + 1), after = h(k + 2), next = first(k + 1);
      const double v = (d * after + next * before) / (before + after), a = 2 * (next - d) / (before + after);
      state_[k] = {control_[k + 1] - v * (after - before) / 3 + a * before * after / 6, v, a, 0};
      if (k > 0) state_[k - 1].jerk = (a - state_[k - 1].acceleration) / step_[k - 1];
      d = next;
    }
  }

  EndSpeeds ends_;
  std::vector<double> step_;  // [s]
  std::vector<double> control_;
  std::vector<State> state_;  // of each knot
};

inline constexpr double kInterval = 0.002;  ///< between knots [s]
inline constexpr std::size_t kLeastIntervals = 8;

/// A part of a plan, between two places where it rests or runs at constant speed.
struct PlanPart {
  const std::vector<Phase>& phases;
  std::size_t first;       ///< phase in which it begins
  double begin, duration;  ///< [s]
  const NodePositions& position;
  std::size_t node;  ///< from which positions count
  double from, to;   ///< [mm] behind it
  ArcMotion::EndSpeeds ends;
};

/// The same on knots.
inline ArcMotion motion_of(const PlanPart& part) {
  const auto n = std::max(kLeastIntervals, static_cast<std::size_t>(std::ceil(part.duration / kInterval)));
  const double step = part.duration / static_cast<double>(n);
  std::vector<double> position(n + 1);
  std::size_t phase = part.first;
  for (std::size_t k = 0; k <= n; ++k) {
    const double t = part.begin + static_cast<double>(k) * step;
    while (phase + 1 < part.phases.size() && part.phases[phase + 1].begin <= t) ++phase;
    const Phase& p = part.phases[phase];
    const double at =
        part.position.between(part.node, p.node) + evaluate(p, std::clamp(t - p.begin, 0.0, p.duration)).distance;
    position[k] = std::clamp(at, k > 0 ? position[k - 1] : part.from, part.to);
  }
  position.front() = part.from;
  position.back() = part.to;
  return {position, step, part.ends};
}

}  // namespace toolpace::detail::retime
