#pragma once
/// Chains of points that runs may be.

#include <cmath>
#include <vector>

#include "toolpace/rewrite/curve.h"

namespace toolpace::test {

using detail::rewrite::Curve;

inline constexpr double kPi = 3.14159265358979323846;

/// Each point is the end of a row.
inline Curve curve_of(const std::vector<Eigen::Vector3d>& points) {
  Curve curve;
  for (std::size_t k = 0; k < points.size(); ++k) {
    curve.point.push_back(points[k]);
    curve.vertex.push_back(static_cast<std::uint32_t>(k));
  }
  curve.barrier.assign(points.size(), 0);
  curve.is_arc.assign(points.size() - 1, 0);
  curve.barrier.front() = curve.barrier.back() = 1;
  return curve;
}

inline Curve circle(double radius, double sweep, int chords, double pitch = 0.0) {
  std::vector<Eigen::Vector3d> points;
  for (int k = 0; k <= chords; ++k) {
    const double angle = sweep * k / chords;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle), pitch * angle / (2 * kPi)});
  }
  return curve_of(points);
}

}  // namespace toolpace::test
