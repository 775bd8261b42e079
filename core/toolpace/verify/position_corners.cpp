#include "toolpace/verify/position_corners.h"

#include <algorithm>
#include <cmath>

namespace toolpace {
namespace {

constexpr double kParallel = 1e-7;  // sine of the angle between chords of one line, beyond what rounding explains

/// XYZ in mm and ABC in rad of the chord that ends at row `local`.
AxisVector chord_to(const RowStream& stream, std::size_t local) {
  AxisVector c = AxisVector::Zero();
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const auto& p = stream.rows().position[axis];
    if (!p.empty()) c[static_cast<Eigen::Index>(axis)] = p[local] - p[local - 1];
  }
  return c;
}

/// What is left of b beside direction a, relative to b.
bool is_parallel(const AxisVector& a, const AxisVector& b, double noise) {
  const double length = a.norm(), other = b.norm();
  if (length <= 0 || other <= 0) return false;
  if (a.dot(b) <= 0) return false;
  const double beside = (b - a * (a.dot(b) / (length * length))).norm();
  return beside <= kParallel * other + 4 * noise * (1 + other / length);
}

/// Whether b, of length > 0, is α·before + β·after with α, β ≥ 0: a chord that cuts one corner.
bool joins(const AxisVector& before, const AxisVector& between, const AxisVector& after, double noise) {
  const AxisVector u = before.normalized(), w = after.normalized();
  const double c = u.dot(w), s = 1 - c * c;
  if (s < kParallel * kParallel) return false;
  const double alpha = (between.dot(u) - c * between.dot(w)) / s;
  const double beta = (between.dot(w) - c * between.dot(u)) / s;
  const double least = -8 * noise / std::sqrt(s);
  if (alpha < least || beta < least) return false;
  return (between - alpha * u - beta * w).norm() <= kParallel * between.norm() + 8 * noise;
}

}  // namespace

CornerEvent corner_between_straights(const RowStream& stream, std::size_t local, double period, double noise) {
  CornerEvent event;
  event.interval = event.corner = stream.row(local);
  if (local < 3 || local + 2 >= stream.rows().count) return event;
  const AxisVector before = chord_to(stream, local - 1), here = chord_to(stream, local),
                   after = chord_to(stream, local + 1);
  if (!is_parallel(chord_to(stream, local - 2), before, noise)) return event;
  if (!is_parallel(after, chord_to(stream, local + 2), noise)) return event;
  const bool inside = joins(before, here, after, noise);
  const bool at_row = is_parallel(before, here, noise) && !is_parallel(here, after, noise);
  if (!inside && !at_row) return event;
  // The speed at the corner lies between the mean speeds before and after, but for what one period changes.
  const double slow = std::min(before.norm(), after.norm()), fast = std::max(before.norm(), after.norm());
  const double speed = (fast + (fast - slow)) / period;
  event.speed_step = speed * (after.normalized() - before.normalized()).cwiseAbs();
  event.acceleration_step = (fast - slow) / (period * period) * (after.normalized() - before.normalized()).cwiseAbs();
  return event;
}

}  // namespace toolpace
