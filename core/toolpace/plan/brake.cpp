#include "toolpace/plan/brake.h"

#include <algorithm>
#include <cmath>

#include "toolpace/plan/phase_writer.h"

namespace toolpace::detail {
namespace {

constexpr PhaseShape kJerk = PhaseShape::constant_jerk;
/// Share by which the present deceleration may be too much: rounding.
constexpr double kSquareMargin = 1e-9;

}  // namespace

std::optional<std::vector<Phase>> brake(double speed, double acceleration, const Brakes& brakes) {
  std::vector<Phase> phases;
  PhaseWriter out(phases);
  double v = speed, a = acceleration, s = 0;
  const auto push = [&](double duration, double jerk) {
    const Phase p{0, duration, s, v, a, jerk, kJerk};
    out.push(p);
    if (!(duration > 0)) return;
    const PhaseState end = evaluate(p, duration);
    s = end.distance;
    v = end.speed;
    a = end.acceleration;
  };
  if (std::isinf(brakes.jerk)) {
    a = -brakes.deceleration;
    push(v / brakes.deceleration, 0);
    return phases;
  }
  if (a > 0) {
    push(a / brakes.release, -brakes.release);
    a = 0;
  }
  const double top = std::max(brakes.deceleration, -a);
  // From a on down to −peak and up to 0 the speed falls by (2·peak² − a²)/2J.
  const double all = v + a * a / (2 * brakes.jerk);
  const double square = brakes.jerk * all;
  if (square < a * a * (1 - kSquareMargin)) return std::nullopt;
  const double peak = std::clamp(std::sqrt(square), -a, top);
  push((peak + a) / brakes.jerk, -brakes.jerk);
  a = -peak;
  const double left = v - peak * peak / (2 * brakes.jerk);
  if (left > 0) push(left / peak, 0);
  push(peak / brakes.jerk, brakes.jerk);
  return phases;
}

}  // namespace toolpace::detail
