#include "preview/motion_state.h"

#include <algorithm>

namespace toolpace::ui {

std::size_t phase_at(const MotionPlan& plan, double time) {
  const auto& phases = plan.phases;
  const auto after =
      std::upper_bound(phases.begin(), phases.end(), time, [](double t, const Phase& p) { return t < p.begin; });
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - phases.begin() - 1, 0));
}

std::size_t block_at(const Outcome& outcome, double time) {
  const auto& arrival = outcome.node_time;
  const auto after = std::upper_bound(arrival.begin(), arrival.end(), time) - arrival.begin();
  return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after - 1, 0, std::ssize(arrival) - 2));
}

const TimeSpline* spline_at(const MotionPlan& plan, double time) {
  const auto after = std::upper_bound(plan.splines.begin(), plan.splines.end(), time,
                                      [](double t, const TimeSpline& s) { return t < s.begin; });
  if (after == plan.splines.begin()) return nullptr;
  const TimeSpline& spline = *std::prev(after);
  return time <= spline.begin + spline.duration() ? &spline : nullptr;
}

PhaseState motion_at(const MotionPlan& plan, double time) {
  const Phase& p = plan.phases[phase_at(plan, time)];
  PhaseState state = evaluate(p, std::clamp(time - p.begin, 0.0, p.duration));
  if (const TimeSpline* spline = spline_at(plan, time)) {
    const SplineState s = evaluate(*spline, std::clamp(time - spline->begin, 0.0, spline->duration()));
    state.speed = s.speed;
    state.acceleration = s.acceleration;
    state.jerk = s.jerk;
  }
  return state;
}

PhaseBounds motion_bounds(const MotionPlan& plan, std::size_t phase, double begin, double end) {
  const Phase& p = plan.phases[phase];
  if (plan.splines.empty() || !spline_at(plan, p.begin + p.duration / 2)) {
    const double from = std::clamp(begin - p.begin, 0.0, p.duration);
    return bounds(p, from, std::clamp(end - p.begin, from, p.duration));
  }
  constexpr int kParts = 10;
  const PhaseState first = motion_at(plan, begin);
  PhaseBounds box{{first.speed, first.speed}, {first.acceleration, first.acceleration}, {first.jerk, first.jerk}};
  for (int k = 1; k <= kParts; ++k) {
    const PhaseState s = motion_at(plan, begin + (end - begin) * k / kParts);
    box.speed.add(s.speed);
    box.acceleration.add(s.acceleration);
    box.jerk.add(s.jerk);
  }
  return box;
}

PhaseBounds motion_bounds(const MotionPlan& plan, std::size_t phase) {
  const Phase& p = plan.phases[phase];
  return motion_bounds(plan, phase, p.begin, p.begin + p.duration);
}

// A cubic between knots: differences over a small part of the step are its derivatives but for rounding.
AxisMotion axis_motion(const TimeSpline& spline, double time, std::size_t axis) {
  const double h = spline.step / 8, length = spline.duration();
  const double t =
      std::clamp(time - spline.begin, std::min(1.5 * h, length / 2), std::max(length - 1.5 * h, length / 2));
  const auto at = [&](double offset) {
    return evaluate(spline, std::clamp(t + offset, 0.0, length)).position[static_cast<Eigen::Index>(axis)];
  };
  const double a = at(-1.5 * h), b = at(-0.5 * h), c = at(0.5 * h), d = at(1.5 * h);
  return {(c - b) / h, (d - c - b + a) / (2 * h * h), (d - 3 * c + 3 * b - a) / (h * h * h)};
}

}  // namespace toolpace::ui
