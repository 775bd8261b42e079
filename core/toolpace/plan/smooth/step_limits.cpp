#include "toolpace/plan/smooth/step_limits.h"

#include <algorithm>
#include <cmath>

namespace toolpace::detail::tube {
namespace {

constexpr double kStep = 0.45, kQuickStep = 0.6;  // of the time in which a corner is turned
constexpr int kCoarseSamples = 2;                 // stations an interval of longer steps, which only prepare

/// Time that a move of the tube's size takes: from jerk ∛(tol/J), from acceleration √(tol/A); the slower one counts.
double turning_time(const TubePath& path, const TubeLimits& limits) {
  double acceleration = limits.path_acceleration, jerk = limits.path_jerk;
  for (int a = 0; a < path.axes; ++a) {
    const auto axis = static_cast<std::size_t>(path.axis[static_cast<std::size_t>(a)]);
    acceleration = std::min(acceleration, limits.acceleration[axis]);
    jerk = std::min(jerk, limits.jerk[axis]);
  }
  const double tolerance = *std::min_element(path.tolerance.begin(), path.tolerance.end());
  return std::max(std::cbrt(tolerance / jerk), std::sqrt(tolerance / acceleration));
}

/// A long path pays for few, a short one can afford more.
int quick_rounds(std::size_t segments) {
  constexpr int kLeast = 5, kMost = 15;
  constexpr std::size_t kShared = 20000;
  return std::min(kMost, kLeast + static_cast<int>(kShared / std::max<std::size_t>(segments, 1)));
}

/// Largest h ≤ wanted, or a little above, that is a whole number of periods or a whole part of one.
double step_near(double wanted, double period) {
  if (wanted >= 0.8 * period) return period * std::clamp(std::floor(wanted / period + 0.2), 1.0, 8.0);
  return period / std::clamp(std::ceil(period / wanted - 0.25), 1.0, 8.0);
}

}  // namespace

StepLimits step_limits(const TubePath& path, const TubeLimits& limits, double period, TubeEffort effort) {
  StepLimits s;
  const bool is_quick = effort == TubeEffort::quick;
  const double h = step_near((is_quick ? kQuickStep : kStep) * turning_time(path, limits), period);
  s.step = h;
  s.samples = std::max(1, static_cast<int>(std::lround(h / period)));
  s.aimed = is_quick ? (s.samples + 1) / 2 : s.samples;
  s.effort = effort;
  s.quick_rounds = quick_rounds(path.segments());
  s.linear = path.linear > 0 ? path.linear : path.axes;
  for (std::size_t a = 0; a < kAxisCount; ++a) {
    if (static_cast<int>(a) >= path.axes) {  // a coordinate that never moves
      for (auto& order : s.order) order[a] = TubeLimits::kNone;
      continue;
    }
    const auto axis = static_cast<std::size_t>(path.axis[a]);
    s.order[0][a] = limits.speed[axis] * h;
    s.order[1][a] = limits.acceleration[axis] * h * h;
    s.order[2][a] = limits.jerk[axis] * h * h * h;
  }
  s.norm[0] = TubeLimits::kNone;
  s.norm[1] = limits.path_acceleration * h * h;
  s.norm[2] = limits.path_jerk * h * h * h;
  return s;
}

StepLimits coarser(const StepLimits& limits, std::size_t by) {
  StepLimits s = limits;
  double factor = 1;
  for (int order = 0; order < 3; ++order) {
    factor *= static_cast<double>(by);
    for (double& l : s.order[order]) l *= factor;
    s.norm[order] *= factor;
  }
  s.step *= static_cast<double>(by);
  s.aimed = s.samples = std::min(kCoarseSamples, s.samples * static_cast<int>(by));
  return s;
}

}  // namespace toolpace::detail::tube
