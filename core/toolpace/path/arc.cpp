#include "toolpace/path/arc.h"

#include <algorithm>
#include <cmath>

namespace toolpace {
namespace {

// Below this relative change of radius an arc is a circle: the change of length is under half an ulp.
constexpr double kCircular = 1e-15;

bool is_circular(const ArcCurve& arc) {
  return std::abs(arc.end_radius - arc.start_radius) <= kCircular * std::max(arc.start_radius, arc.end_radius);
}

double growth(const ArcCurve& arc) { return (arc.end_radius - arc.start_radius) / arc.sweep; }

/// Length from the start to `angle` of an arc whose radius changes: ∫ √(r² + k² + h²) dφ, r = r0 + kφ.
double spiral_length(const ArcCurve& arc, double angle) {
  const double k = growth(arc), h = arc.rise / arc.sweep;
  const double c2 = k * k + h * h;
  // Where the radius changes little the integrand is almost linear and quadrature is exact to rounding; the closed form
  // would cancel there.
  if (std::abs(arc.end_radius - arc.start_radius) < 0.1 * std::min(arc.start_radius, arc.end_radius)) {
    return integrate([&](double phi) { return std::sqrt(std::pow(arc.start_radius + k * phi, 2) + c2); }, 0.0, angle);
  }
  const double c = std::sqrt(c2);
  const auto primitive = [&](double u) { return (u * std::sqrt(u * u + c2) + c2 * std::asinh(u / c)) / 2; };
  return (primitive(arc.start_radius + k * angle) - primitive(arc.start_radius)) / k;
}

Eigen::Vector3d outward(const ArcCurve& arc, double angle) {
  return std::cos(angle) * arc.radial + std::sin(angle) * arc.lateral;
}

}  // namespace

ArcCurve make_arc(const AxisVector& begin, const AxisVector& end, const ArcDetail& detail) {
  ArcCurve arc;
  arc.centre = detail.centre;
  arc.normal = detail.normal;
  if (detail.sweep < 0) arc.normal = -arc.normal;
  arc.sweep = std::abs(detail.sweep);
  const Eigen::Vector3d from = begin.head<3>() - detail.centre, to = end.head<3>() - detail.centre;
  const double level = arc.normal.dot(from);
  const Eigen::Vector3d start = from - level * arc.normal;
  arc.centre += level * arc.normal;
  arc.start_radius = start.norm();
  arc.rise = arc.normal.dot(to) - level;
  arc.end_radius = (to - arc.normal.dot(to) * arc.normal).norm();
  arc.radial = arc.start_radius > 0 ? Eigen::Vector3d(start / arc.start_radius) : arc.normal.unitOrthogonal();
  arc.lateral = arc.normal.cross(arc.radial);
  return arc;
}

double arc_length(const ArcCurve& arc) {
  if (is_circular(arc)) return std::hypot(arc.start_radius * arc.sweep, arc.rise);
  return spiral_length(arc, arc.sweep);
}

double angle_at(const ArcCurve& arc, double length, double s) {
  double angle = arc.sweep * (s / length);
  if (is_circular(arc)) return angle;
  const double k = growth(arc), h = arc.rise / arc.sweep;
  for (int i = 0; i < 20; ++i) {  // Newton on a convex or concave monotone function: quadratic from anywhere
    const double slope = std::sqrt(std::pow(arc.start_radius + k * angle, 2) + k * k + h * h);
    const double step = (spiral_length(arc, angle) - s) / slope;
    angle = std::clamp(angle - step, 0.0, arc.sweep);
    if (std::abs(step) <= 1e-15 * arc.sweep) break;
  }
  return angle;
}

AxisVector arc_point(const ArcCurve& arc, double angle) {
  AxisVector point = AxisVector::Zero();
  point.head<3>() = arc.centre + (arc.start_radius + growth(arc) * angle) * outward(arc, angle) +
                    (arc.rise * (angle / arc.sweep)) * arc.normal;
  return point;
}

ParameterDerivatives arc_derivatives(const ArcCurve& arc, double angle) {
  const double k = growth(arc), r = arc.start_radius + k * angle;
  const Eigen::Vector3d out = outward(arc, angle);
  const Eigen::Vector3d along = arc.normal.cross(out);
  ParameterDerivatives d{AxisVector::Zero(), AxisVector::Zero(), AxisVector::Zero()};
  d.first.head<3>() = k * out + r * along + (arc.rise / arc.sweep) * arc.normal;
  d.second.head<3>() = 2 * k * along - r * out;
  d.third.head<3>() = -3 * k * out - r * along;
  return d;
}

ArcCurve part_of_arc(const ArcCurve& arc, double length, double begin, double end) {
  const double from = begin > 0 ? angle_at(arc, length, begin) : 0,
               to = end < length ? angle_at(arc, length, end) : arc.sweep;
  const auto radius = [&](double angle) {
    return arc.start_radius + (arc.end_radius - arc.start_radius) * angle / arc.sweep;
  };
  ArcCurve part = arc;
  part.centre = arc.centre + (arc.rise * from / arc.sweep) * arc.normal;
  part.radial = std::cos(from) * arc.radial + std::sin(from) * arc.lateral;
  part.lateral = std::cos(from) * arc.lateral - std::sin(from) * arc.radial;
  part.start_radius = radius(from);
  part.end_radius = radius(to);
  part.sweep = to - from;
  part.rise = arc.rise * (to - from) / arc.sweep;
  return part;
}

}  // namespace toolpace
