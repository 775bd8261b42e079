#include "toolpace/verify/arc_sector.h"

#include <algorithm>
#include <cmath>

namespace toolpace {
namespace {

constexpr double kBeyond = 0.5;      // [rad] how far past the ends the nearest place is looked for
constexpr double kParabolic = 1e-3;  // [rad] in which the square of a distance is a parabola to w²/12
constexpr double kStill = 1e-13;     // [rad] a step that is rounding
constexpr int kMostSteps = 40;

}  // namespace

ArcSector::ArcSector(const ArcCurve& arc, double begin_angle, double end_angle) {
  const double middle = (begin_angle + end_angle) / 2;
  half_ = (end_angle - begin_angle) / 2;
  widening_ = (arc.end_radius - arc.start_radius) / arc.sweep;
  rise_ = arc.rise / arc.sweep;
  radius_ = arc.start_radius + widening_ * middle;
  outward_ = std::cos(middle) * arc.radial + std::sin(middle) * arc.lateral;
  along_ = std::cos(middle) * arc.lateral - std::sin(middle) * arc.radial;
  normal_ = arc.normal;
  centre_ = arc.centre + rise_ * middle * arc.normal;
}

Eigen::Vector3d ArcSector::point(double share) const {
  const double angle = angle_of(share), r = radius_ + widening_ * angle;
  return centre_ + r * std::cos(angle) * outward_ + r * std::sin(angle) * along_ + rise_ * angle * normal_;
}

ArcSector::Local ArcSector::local(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d from = point - centre_;
  const double u = from.dot(outward_), w = from.dot(along_);
  return {std::sqrt(u * u + w * w), std::atan2(w, u), from.dot(normal_)};
}

/// Square of the distance, without the cancellation of large squares.
double ArcSector::square(const Local& at, double angle) const {
  const double r = radius_ + widening_ * angle, h = at.height - rise_ * angle;
  const double across = std::sin((angle - at.angle) / 2);
  return (r - at.radius) * (r - at.radius) + 4 * r * at.radius * across * across + h * h;
}

double ArcSector::half_slope(const Local& at, double angle) const {
  const double r = radius_ + widening_ * angle, turn = angle - at.angle;
  return widening_ * (r - at.radius * std::cos(turn)) + r * at.radius * std::sin(turn) -
         rise_ * (at.height - rise_ * angle);
}

double ArcSector::half_bend(const Local& at, double angle) const {
  const double r = radius_ + widening_ * angle, turn = angle - at.angle;
  return widening_ * widening_ + rise_ * rise_ + r * at.radius * std::cos(turn) +
         2 * widening_ * at.radius * std::sin(turn);
}

double ArcSector::nearest_angle(const Local& at) const {
  const double most = half_ + kBeyond;
  double angle = std::clamp(at.angle, -most, most);
  for (int i = 0; i < kMostSteps; ++i) {
    const double bend = half_bend(at, angle);
    if (!(bend > 0)) break;
    const double step = half_slope(at, angle) / bend;
    angle = std::clamp(angle - step, -most, most);
    if (std::abs(step) <= kParabolic * kParabolic) break;  // Newton's next step would be its square
  }
  return angle;
}

/// Between a place inside of the distance and one outside: Newton, bracketed, from a first guess on.
double ArcSector::edge(const Local& at, double inside, double outside, double guess, double radius_square) const {
  double angle = (guess - inside) * (guess - outside) < 0 ? guess : outside;
  for (int i = 0; i < kMostSteps && std::abs(outside - inside) > kStill; ++i) {
    const double excess = square(at, angle) - radius_square;
    (excess > 0 ? outside : inside) = angle;
    const double slope = 2 * half_slope(at, angle);
    double next = slope != 0 ? angle - excess / slope : inside;
    const bool between = (next - inside) * (next - outside) < 0;
    if (!between) next = (inside + outside) / 2;
    if (std::abs(next - angle) <= kStill) break;
    angle = next;
  }
  return angle;
}

CurveInterval ArcSector::within(const Eigen::Vector3d& point, double radius) const {
  CurveInterval interval;
  const Local at = local(point);
  const bool is_circle = widening_ == 0.0 && rise_ == 0.0;
  const double nearest = is_circle ? at.angle : nearest_angle(at);
  const double off = radius_ - at.radius;
  const double least = is_circle ? off * off + at.height * at.height : square(at, nearest);
  interval.nearest = share_of(nearest);
  interval.distance = std::sqrt(least);
  const double rest = radius * radius - least;
  if (!(rest >= 0)) return interval;
  const double bend = is_circle ? radius_ * at.radius : half_bend(at, nearest);
  const double width = bend > 0 ? std::sqrt(rest / bend) : 2 * kParabolic;
  double low = nearest - width, high = nearest + width;
  if (width > kParabolic) {
    const double limit = radius * radius, middle = std::clamp(nearest, -half_, half_);
    if (square(at, middle) > limit) return interval;
    // That of a circle in the plane, which most are but for what rounds them.
    const double half_sine = 0.5 * width, reach = half_sine < 1 ? 2 * std::asin(half_sine) : kBeyond;
    low = square(at, -half_) <= limit ? -half_ : edge(at, middle, -half_, nearest - reach, limit);
    high = square(at, half_) <= limit ? half_ : edge(at, middle, half_, nearest + reach, limit);
  }
  if (high < -half_ || low > half_) return interval;
  interval.low = std::max(0.0, share_of(low));
  interval.high = std::min(1.0, share_of(high));
  return interval;
}

double ArcSector::distance(const Eigen::Vector3d& point, double share) const {
  return std::sqrt(square(local(point), angle_of(share)));
}

double ArcSector::bulge(double from, double to) const {
  const double quarter = (to - from) * half_ / 2;  // of the angle
  return 2 * (radius_ + std::abs(widening_) * half_) * quarter * quarter;
}

}  // namespace toolpace
