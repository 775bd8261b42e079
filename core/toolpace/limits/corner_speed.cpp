#include <algorithm>
#include <cmath>
#include <numbers>

#include "toolpace/base/axis_unit.h"
#include "toolpace/limits/limit_speed.h"

namespace toolpace {
namespace {

// Directions that differ by less than rounding of six-decimal coordinates on a millimetre can tell are one direction.
constexpr double kSameDirection = 1e-9;

constexpr Metric kApart = Metric::apart();

/// Each axis' own limit, or the path's where it has none.
double axis_acceleration(const Machine& machine, std::size_t k) {
  if (machine.axes[k].acceleration < kUnlimited) return machine.axes[k].acceleration;
  return machine.path.acceleration * axis_unit(k).size;
}

double servo_speed(const AxisVector& step, const Machine& machine) {
  double angle_acceleration = machine.path.acceleration;
  double speed = kUnlimited, slowest_axis = kUnlimited;
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    const double change = std::abs(step[static_cast<Eigen::Index>(k)]);
    const double limit = axis_acceleration(machine, k);
    if (change <= 0 || !(limit < kUnlimited)) continue;
    speed = std::min(speed, limit * machine.period / change);
    slowest_axis = std::min(slowest_axis, counted(k, limit));
  }
  if (!(angle_acceleration < kUnlimited)) angle_acceleration = slowest_axis;
  const double chord = kApart.norm(step);  // 2·sin(α/2) for unit directions
  return chord > 0 ? std::min(speed, angle_acceleration * machine.period / chord) : speed;
}

/// What the axes leave along the direction in which the velocity turns.
double turning_acceleration(const AxisVector& step, const Machine& machine) {
  double acceleration = machine.path.acceleration;
  const double length = kApart.norm(step);
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    const double share = std::abs(step[static_cast<Eigen::Index>(k)]) / length;
    if (share > 0) acceleration = std::min(acceleration, machine.axes[k].acceleration / share);
  }
  return acceleration;
}

/// δ = the distance by which an arc tangent to both lines, run at centripetal acceleration a, misses the corner.
double junction_speed(double half_chord, double acceleration, double deviation) {
  const double sine = std::min(half_chord, 1.0);  // sin(α/2) for unit directions
  const double cosine = std::sqrt((1 - sine) * (1 + sine));
  const double missing = sine * sine / (1 + cosine);  // 1 − cos(α/2) without cancellation
  return std::sqrt(acceleration * deviation * cosine / missing);
}

}  // namespace

double corner_speed(const CornerOptions& corner, const AxisVector& before, const AxisVector& after,
                    const Machine& machine) {
  const AxisVector step = after - before;
  const double chord = kApart.norm(step);
  if (corner.step) return chord > 0 ? *corner.step / chord : kUnlimited;
  if (corner.rule == CornerRule::stop) return 0.0;
  if (chord <= kSameDirection) return kUnlimited;
  switch (corner.rule) {
    case CornerRule::junction:
      return junction_speed(chord / 2, turning_acceleration(step, machine), corner.junction_deviation);
    case CornerRule::blend:
    case CornerRule::smooth: return 0.0;  // a corner that could not be rounded stops
    default: return servo_speed(step, machine);
  }
}

double corner_speed(const MotionCeiling& ceiling, const AxisVector& before, const AxisVector& after,
                    const Machine& machine) {
  const AxisVector step = after - before;
  const double chord = kApart.norm(step);
  if (chord <= kSameDirection || !ceiling.limits_corners()) return kUnlimited;
  double speed = kUnlimited;
  for (Eigen::Index k = 0; k < step.size(); ++k) {
    if (step[k] != 0) speed = std::min(speed, ceiling.corner_step[k] / std::abs(step[k]));
  }
  if (ceiling.corner_speed < kUnlimited) {
    // cos(α/2)/(1 − cos(α/2)) is 1/(√2 − 1) at a right angle.
    const double product = ceiling.corner_speed * ceiling.corner_speed * (std::numbers::sqrt2 - 1);
    speed = std::min(speed, junction_speed(chord / 2, 1.0, product));
  }
  if (ceiling.junction_deviation < kUnlimited) {
    const double acceleration = turning_acceleration(step, machine);
    speed = std::min(speed, junction_speed(chord / 2, acceleration, ceiling.junction_deviation));
  }
  return speed;
}

}  // namespace toolpace
