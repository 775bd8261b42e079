#pragma once
/// Plane geometry of offset contours: lines and arcs, where they meet, which way they go.

#include <optional>

namespace toolpace::nc {

struct Point {
  double x = 0.0, y = 0.0;
};
inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
inline Point operator*(Point a, double f) { return {a.x * f, a.y * f}; }
inline double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
inline double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
double norm(Point a);
/// Turned by a quarter: to the left where `sense` > 0, else to the right.
inline Point turned(Point a, double sense) { return sense > 0.0 ? Point{-a.y, a.x} : Point{a.y, -a.x}; }
/// [rad] from a to b, −π … π, counter-clockwise positive.
double angle_between(Point a, Point b);

/// A line (turn 0) or an arc that the tool's centre follows.
struct OffsetElement {
  Point start, end, centre;
  int turn = 0;  ///< sign: + counter-clockwise
};

Point direction_at_start(const OffsetElement& element);
Point direction_at_end(const OffsetElement& element);

/// Where two elements, each prolonged, meet: on `a` itself if they do so at one place there, else nearest to `near`.
std::optional<Point> intersect(const OffsetElement& a, const OffsetElement& b, Point near);

/// The point of a prolonged line nearest to `p`.
Point foot_on_line(const OffsetElement& line, Point p);

/// Where two elements, each prolonged, meet nearest to `near`; of two places as near, the one on the elements themselves.
std::optional<Point> meeting_of(const OffsetElement& a, const OffsetElement& b, Point near);

/// True if the element passes through `p`, a point on its prolongation, after its start.
bool lies_on(const OffsetElement& element, Point p);

}  // namespace toolpace::nc
