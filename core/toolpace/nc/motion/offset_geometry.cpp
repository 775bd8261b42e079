#include "toolpace/nc/motion/offset_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "toolpace/base/axes.h"

namespace toolpace::nc {
namespace {

constexpr double kTouching = 1e-7;  // of the radius: nearer than this, elements touch
constexpr double kAlike = 0.1;      // distances that differ by less decide nothing

using Candidates = std::array<std::optional<Point>, 2>;

Candidates line_with_line(const OffsetElement& a, const OffsetElement& b) {
  const Point u = a.end - a.start, v = b.end - b.start;
  const double denominator = cross(u, v);
  if (std::fabs(denominator) < 1e-12 * norm(u) * norm(v)) return {};
  return {a.start + u * (cross(b.start - a.start, v) / denominator), std::nullopt};
}

Candidates line_with_circle(const OffsetElement& line, const OffsetElement& arc) {
  const double radius = norm(arc.end - arc.centre);
  const Point along = (line.end - line.start) * (1.0 / norm(line.end - line.start));
  const Point foot = foot_on_line(line, arc.centre);
  const double off = norm(foot - arc.centre);
  if (off > radius * (1.0 + kTouching)) return {};
  const double half = std::sqrt(std::max(0.0, radius * radius - off * off));
  return {foot + along * half, foot - along * half};
}

Candidates circle_with_circle(const OffsetElement& a, const OffsetElement& b) {
  const double ra = norm(a.end - a.centre), rb = norm(b.end - b.centre);
  const Point between = b.centre - a.centre;
  const double distance = norm(between);
  if (distance == 0.0 || distance > (ra + rb) * (1.0 + kTouching)) return {};
  const double along = (ra * ra - rb * rb + distance * distance) / (2.0 * distance);
  if (std::fabs(along) > ra * (1.0 + kTouching)) return {};
  const double beside = std::sqrt(std::max(0.0, ra * ra - along * along));
  const Point unit = between * (1.0 / distance);
  const Point foot = a.centre + unit * along;
  return {foot + turned(unit, 1.0) * beside, foot + turned(unit, -1.0) * beside};
}

Candidates meetings(const OffsetElement& a, const OffsetElement& b) {
  if (a.turn == 0 && b.turn == 0) return line_with_line(a, b);
  if (a.turn == 0) return line_with_circle(a, b);
  if (b.turn == 0) return line_with_circle(b, a);
  return circle_with_circle(a, b);
}

Point nearer(const Candidates& found, Point near) {
  return norm(*found[0] - near) <= norm(*found[1] - near) ? *found[0] : *found[1];
}

// Angle from `from` to `to` about the centre, in the arc's sense, 0 … 2π.
double swept(const OffsetElement& arc, Point from, Point to) {
  const double angle = angle_between(from - arc.centre, to - arc.centre) * (arc.turn > 0 ? 1.0 : -1.0);
  return angle < 0.0 ? angle + kTwoPi : angle;
}

}  // namespace

double norm(Point a) { return std::hypot(a.x, a.y); }

double angle_between(Point a, Point b) { return std::atan2(cross(a, b), dot(a, b)); }

Point direction_at_start(const OffsetElement& element) {
  if (element.turn == 0) return element.end - element.start;
  return turned(element.start - element.centre, element.turn > 0 ? 1.0 : -1.0);
}

Point direction_at_end(const OffsetElement& element) {
  if (element.turn == 0) return element.end - element.start;
  return turned(element.end - element.centre, element.turn > 0 ? 1.0 : -1.0);
}

Point foot_on_line(const OffsetElement& line, Point p) {
  const Point along = (line.end - line.start) * (1.0 / norm(line.end - line.start));
  return line.start + along * dot(p - line.start, along);
}

std::optional<Point> intersect(const OffsetElement& a, const OffsetElement& b, Point near) {
  const Candidates found = meetings(a, b);
  if (!found[0] || !found[1]) return found[0];
  const bool first_on = lies_on(a, *found[0]), second_on = lies_on(a, *found[1]);
  if (first_on != second_on) return first_on ? found[0] : found[1];
  return nearer(found, near);
}

std::optional<Point> meeting_of(const OffsetElement& a, const OffsetElement& b, Point near) {
  const Candidates found = meetings(a, b);
  if (!found[0] || !found[1]) return found[0];
  const double first = norm(*found[0] - near), second = norm(*found[1] - near);
  if (std::fabs(first - second) > kAlike * std::max(first, second)) return nearer(found, near);
  const auto on = [&](Point p) { return (lies_on(a, p) ? 1 : 0) + (lies_on(b, p) ? 1 : 0); };
  return on(*found[0]) >= on(*found[1]) ? found[0] : found[1];
}

bool lies_on(const OffsetElement& element, Point p) {
  if (element.turn != 0) {
    double whole = swept(element, element.start, element.end);
    if (whole < kTouching) whole = kTwoPi;
    return swept(element, element.start, p) <= whole + kTouching;
  }
  const Point along = element.end - element.start;
  const double t = dot(p - element.start, along);
  return t > 0.0 && t <= dot(along, along) * (1.0 + kTouching);
}

}  // namespace toolpace::nc
