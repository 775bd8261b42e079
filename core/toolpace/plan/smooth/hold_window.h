#pragma once
/// A feed hold in a motion through the tube: a stop, a rest, and the way back into the motion.

#include <optional>

#include "toolpace/plan/smooth/motion_parts.h"
#include "toolpace/plan/smooth/window_optimiser.h"

namespace toolpace::detail::tube {

/// Replaces a stretch of a motion by one that comes to rest inside the tube and starts again: first the motion itself with
/// its time slowed down to nothing and up again, then made as fast as the limits allow, with both ends of the stretch and the
/// place of the rest held fast.
template <int D>
class HoldWindow {
 public:
  using Vec = Eigen::Matrix<double, D, 1>;
  HoldWindow(const TubePath& path, const StepLimits& limits) : optimiser_(path, limits), limits_(limits) {}

  /// @param at    [steps] u of the whole motion from which on it brakes, as soon as a stop passes every check
  /// @param rest  [steps] ≥ 0
  /// @return nothing where it was cancelled
  std::optional<MotionWindow<D>> apply(const MotionWindow<D>& m, double at, std::size_t rest, const Monitor& monitor) {
    const std::size_t last = m.size() - 2;  // knot at the end
    for (auto knot = static_cast<std::size_t>(std::ceil(std::max(at, 1.0))); knot < last; knot += kLater) {
      if (rests(m, knot)) return with_rest(m, knot, rest);
      std::size_t half = braking_steps(m, knot);
      for (int i = 0; i < kAttempts && knot + half < last; ++i, half += half / 2 + 1) {
        if (auto held = stop_over(m, knot, half, rest, monitor)) return held;
        if (monitor.is_cancelled()) return {};
      }
    }
    return with_rest(m, last, rest);
  }

 private:
  static constexpr int kAttempts = 5;
  static constexpr std::size_t kLater = 20;  // steps, where no stop could be found
  static constexpr double kBrakingRoom = 1.2;

  static bool rests(const MotionWindow<D>& m, std::size_t knot) {
    return m.c[knot - 1] == m.c[knot] && m.c[knot] == m.c[knot + 1];
  }

  /// Steps of the motion's own time that it still goes on: half of those that each axis needs to brake.
  std::size_t braking_steps(const MotionWindow<D>& m, std::size_t knot) const {
    const Vec v = 0.5 * (m.c[knot + 1] - m.c[knot - 1]);
    double most = 4;
    for (int order = 1; order < 3; ++order) {
      const double speed = v.norm() / limits_.norm[order];
      most = std::max(most, order == 1 ? speed : 2 * std::sqrt(speed));
      for (int a = 0; a < D; ++a) {
        const double part = std::abs(v[a]) / limits_.order[order][a];
        most = std::max(most, order == 1 ? part : 2 * std::sqrt(part));
      }
    }
    return static_cast<std::size_t>(std::ceil(kBrakingRoom * most / 2)) + 2;
  }

  std::optional<MotionWindow<D>> stop_over(const MotionWindow<D>& m, std::size_t knot, std::size_t half,
                                           std::size_t rest, const Monitor& monitor) {
    const std::size_t stop = knot + half, back = std::min(stop + half, m.size() - 2);
    auto brake = slowed(m, knot, stop, false);
    if (!optimiser_.improve(brake, monitor)) return {};
    auto start = slowed(m, stop, back, true);
    if (!optimiser_.improve(start, monitor)) return {};
    MotionWindow<D> whole = part(m, 1, knot);
    join(whole, brake);
    whole = with_rest(whole, whole.size() - 2, rest);
    join(whole, start);
    join(whole, part(m, back, m.size() - 2));
    return whole;
  }

  /// The motion with some steps more at a knot where it is at rest.
  static MotionWindow<D> with_rest(MotionWindow<D> m, std::size_t knot, std::size_t steps) {
    m.c.insert(m.c.begin() + static_cast<std::ptrdiff_t>(knot), steps, Vec(m.c[knot]));
    for (double& u : m.pass) u += u > static_cast<double>(knot) ? static_cast<double>(steps) : 0.0;
    return m;
  }

  /// Knots begin … end, run at a pace that falls from 1 to 0 in twice their time, or rises from 0 to 1.
  MotionWindow<D> slowed(const MotionWindow<D>& m, std::size_t begin, std::size_t end, bool starts) const {
    MotionWindow<D> r = part(m, begin, end);
    const MotionWindow<D> from = r;
    const std::size_t way = end - begin, steps = 2 * way;
    const bool reaches_end = starts && from.rest_end;
    r.c.assign(steps + 3, Vec::Zero());
    for (std::size_t j = 0; j < r.c.size(); ++j) {
      const double t = (static_cast<double>(j) - 1) / static_cast<double>(steps);
      const Pace pace = starts ? mirrored(pace_at(1 - t)) : pace_at(t);
      const double u = 1 + pace.done * static_cast<double>(way);
      double local;
      const std::size_t k = from.cell(u, local);
      const Vec x = from.combine(k, basis(local)), v = from.combine(k, basis_slope(local));
      const Vec a = from.combine(k, basis_bend(local));
      r.c[j] = x - (a * pace.rate * pace.rate + v * pace.gain / static_cast<double>(steps)) / 6;
    }
    set_ends(r, from, starts, reaches_end);
    for (double& u : r.pass) u = 1 + static_cast<double>(steps) * time_of((u - 1) / static_cast<double>(way), starts);
    return r;
  }

  void set_ends(MotionWindow<D>& r, const MotionWindow<D>& from, bool starts, bool reaches_end) const {
    const std::size_t n = r.size(), last = from.size() - 1;
    double local;
    const std::size_t k = from.cell(starts ? 1.0 : static_cast<double>(last) - 1, local);
    const Vec place = from.combine(k, basis(local));  // of the rest
    for (std::size_t j = 0; j < 3; ++j) {
      r.c[j] = starts ? place : from.c[j];
      r.c[n - 1 - j] = starts ? from.c[last - j] : place;
    }
    r.rest_begin = starts || from.rest_begin;
    r.rest_end = !starts || reaches_end;
  }

  /// Share of the way after share t of the time, its first derivative in steps a step, its second in steps² a share.
  struct Pace {
    double done, rate, gain;
  };
  /// rate = 1 − σ(t), σ = 10t³ − 15t⁴ + 6t⁵; the whole way is half of what full pace would take.
  static Pace pace_at(double t) {
    t = std::clamp(t, 0.0, 1.0);
    const double t2 = t * t, t3 = t2 * t;
    const double area = t - t2 * t2 * (2.5 - 3 * t + t2);
    return {2 * area, 1 - t3 * (10 - 15 * t + 6 * t2), -30 * t2 * (1 - t) * (1 - t)};
  }
  static Pace mirrored(const Pace& p) { return {1 - p.done, p.rate, -p.gain}; }
  static double time_of(double done, bool starts) {
    double low = 0, high = 1;
    for (int i = 0; i < 40; ++i) {
      const double middle = (low + high) / 2;
      const double there = starts ? 1 - pace_at(1 - middle).done : pace_at(middle).done;
      (there < done ? low : high) = middle;
    }
    return low;
  }

  WindowOptimiser<D> optimiser_;
  const StepLimits& limits_;
};

}  // namespace toolpace::detail::tube
