#include "toolpace/nc/motion/spline_length.h"

#include <vector>

namespace toolpace::nc {
namespace {

constexpr int kChords = 32;  // of a knot span, at the lower density

/// The point at u of knot span `span` (knots[span] ≤ u ≤ knots[span + 1]), by de Boor's scheme in homogeneous
/// coordinates.
/// @source Piegl and Tiller, The NURBS Book, algorithms A3.1 and A4.1
Eigen::Vector3d point_at(const SplineDetail& spline, std::size_t span, double u, std::vector<Eigen::Vector4d>& work) {
  const auto degree = static_cast<std::size_t>(spline.degree);
  work.resize(degree + 1);
  for (std::size_t i = 0; i <= degree; ++i) {
    const std::size_t k = span - degree + i;
    work[i] << spline.points[k] * spline.weights[k], spline.weights[k];
  }
  for (std::size_t r = 1; r <= degree; ++r) {
    for (std::size_t i = degree; i >= r; --i) {
      const double low = spline.knots[span - degree + i], high = spline.knots[span + 1 + i - r];
      const double share = (u - low) / (high - low);
      work[i] = (1.0 - share) * work[i - 1] + share * work[i];
    }
  }
  return work[degree].head<3>() / work[degree][3];
}

}  // namespace

double length_of_spline(const SplineDetail& spline) {
  std::vector<Eigen::Vector4d> work;
  double length = 0.0;
  for (auto span = static_cast<std::size_t>(spline.degree); span + 1 < spline.points.size() + 1; ++span) {
    const double begin = spline.knots[span], end = spline.knots[span + 1];
    if (!(end > begin)) continue;
    double coarse = 0.0, fine = 0.0;
    Eigen::Vector3d last = point_at(spline, span, begin, work), last_even = last;
    for (int k = 1; k <= 2 * kChords; ++k) {
      const Eigen::Vector3d point = point_at(spline, span, begin + (end - begin) * k / (2 * kChords), work);
      fine += (point - last).norm();
      last = point;
      if (k % 2 == 0) {
        coarse += (point - last_even).norm();
        last_even = point;
      }
    }
    length += fine + (fine - coarse) / 3.0;  // the error of chords falls with the square of their length
  }
  return length;
}

}  // namespace toolpace::nc
