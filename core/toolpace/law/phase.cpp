#include "toolpace/law/phase.h"

#include <algorithm>
#include <cmath>

namespace toolpace {
namespace {

PhaseExtrema form_extrema(const Phase& p) {
  const double last = p.speed + p.rate;
  PhaseExtrema e{std::min(p.speed, last), std::max(p.speed, last), 0.0, 0.0, 0.0};
  if (p.duration <= 0 || p.rate == 0) return e;
  visit_form(p.shape, [&]<class Form>(Form) {
    const double steepest = Form::kSteepest * std::abs(p.rate) / p.duration;
    (p.rate > 0 ? e.max_acceleration : e.max_deceleration) = steepest;
    e.max_jerk = Form::kSharpest * std::abs(p.rate) / (p.duration * p.duration);
  });
  return e;
}

}  // namespace

PhaseExtrema extrema(const Phase& p) {
  if (p.shape != PhaseShape::constant_jerk) return form_extrema(p);
  const PhaseState last = evaluate(p, p.duration);
  PhaseExtrema e{std::min(p.speed, last.speed), std::max(p.speed, last.speed),
                 std::max({0.0, p.acceleration, last.acceleration}),
                 std::max({0.0, -p.acceleration, -last.acceleration}), p.duration > 0 ? std::abs(p.rate) : 0.0};
  if ((p.acceleration < 0) != (last.acceleration < 0) && p.rate != 0) {  // the speed turns inside the phase
    const double turn = p.speed - p.acceleration * p.acceleration / (2 * p.rate);
    e.min_speed = std::min(e.min_speed, turn);
    e.max_speed = std::max(e.max_speed, turn);
  }
  return e;
}

}  // namespace toolpace
