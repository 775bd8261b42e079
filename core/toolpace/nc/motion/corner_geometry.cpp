#include "toolpace/nc/motion/corner_geometry.h"

#include <cmath>

#include "toolpace/base/axes.h"

namespace toolpace::nc {
namespace {

constexpr double kWholeLine = 1.0 + 1e-9;  // a chamfer may take the whole line beside it
constexpr double kNoCorner = 1e-9;         // [rad] smoother than this there is no corner to finish

// The foot of `centre` on the element's line or circle.
Point foot_on(const OffsetElement& e, Point centre) {
  if (e.turn == 0) return foot_on_line(e, centre);
  const Point out = centre - e.centre;
  return e.centre + out * (norm(e.start - e.centre) / norm(out));
}

// The element moved to its left by `distance`; false where an arc would vanish.
bool move_left(OffsetElement& e, double distance) {
  if (e.turn == 0) {
    const Point aside = turned(e.end - e.start, 1.0) * (distance / norm(e.end - e.start));
    e.start = e.start + aside;
    e.end = e.end + aside;
    return true;
  }
  const double radius = norm(e.start - e.centre);
  const double factor = (radius - (e.turn > 0 ? distance : -distance)) / radius;
  e.start = e.centre + (e.start - e.centre) * factor;
  e.end = e.centre + (e.end - e.centre) * factor;
  return factor > 0.0;
}

OffsetElement reversed(const OffsetElement& e) { return {e.end, e.start, e.centre, -e.turn}; }

// The point of the element at `length` from its start, as the crow flies; false beyond its end.
bool point_after_start(const OffsetElement& e, double length, Point& p) {
  if (e.turn == 0) {
    const double whole = norm(e.end - e.start);
    p = length < whole ? e.start + (e.end - e.start) * (length / whole) : e.end;
    return length <= whole * kWholeLine;
  }
  const double radius = norm(e.start - e.centre);
  if (!(length < 2.0 * radius)) return false;
  const double angle = std::copysign(2.0 * std::asin(length / (2.0 * radius)), static_cast<double>(e.turn));
  const Point from = e.start - e.centre;
  p = e.centre +
      Point{from.x * std::cos(angle) - from.y * std::sin(angle), from.x * std::sin(angle) + from.y * std::cos(angle)};
  return lies_on(e, p);
}

}  // namespace

bool is_corner(const OffsetElement& before, const OffsetElement& after) {
  return std::fabs(angle_between(direction_at_end(before), direction_at_start(after))) >= kNoCorner;
}

bool round_corner(OffsetElement& before, OffsetElement& after, double radius, OffsetElement& between) {
  const double angle = angle_between(direction_at_end(before), direction_at_start(after));
  const double side = angle > 0.0 ? 1.0 : -1.0;
  OffsetElement a = before, b = after;
  if (!move_left(a, side * radius) || !move_left(b, side * radius)) return false;
  const auto centre = meeting_of(a, b, before.end);
  if (!centre) return false;
  OffsetElement arc{foot_on(before, *centre), foot_on(after, *centre), *centre, angle > 0.0 ? 1 : -1};
  if (!lies_on(before, arc.start) || !lies_on(reversed(after), arc.end)) return false;
  between = arc;
  before.end = arc.start;
  after.start = arc.end;
  return true;
}

bool break_corner(OffsetElement& before, OffsetElement& after, double length, OffsetElement& between) {
  Point begin, end;
  if (!point_after_start(reversed(before), length, begin) || !point_after_start(after, length, end)) return false;
  between = {begin, end, {}, 0};
  before.end = begin;
  after.start = end;
  return true;
}

bool find_meeting_of_lines(Point a, double angle_of_a, Point b, double angle_of_b, Point& meeting) {
  const auto direction = [](double angle) {
    return Point{std::cos(angle * kRadiansPerDegree), std::sin(angle * kRadiansPerDegree)};
  };
  const Point along = direction(angle_of_a), other = direction(angle_of_b);
  const double sine = cross(along, other);
  if (std::fabs(sine) < kNoCorner) return false;
  meeting = a + along * (cross(b - a, other) / sine);
  return true;
}

}  // namespace toolpace::nc
