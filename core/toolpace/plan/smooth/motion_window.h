#pragma once
/// A stretch of motion under optimisation: control points of a uniform cubic B-spline in time, and when it passes which vertex.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "toolpace/plan/smooth/tube_path.h"

namespace toolpace::detail::tube {

/// Values of the four cubic B-spline basis functions that reach into one knot interval, and their derivatives.
struct Basis {
  double w[4];
};
inline Basis basis(double t) {
  const double s = 1 - t;
  return {{s * s * s / 6, (4 - 6 * t * t + 3 * t * t * t) / 6, (4 - 6 * s * s + 3 * s * s * s) / 6, t * t * t / 6}};
}
inline Basis basis_slope(double t) {
  const double s = 1 - t;
  return {{-s * s / 2, (3 * t * t - 4 * t) / 2, (4 * s - 3 * s * s) / 2, t * t / 2}};
}
inline Basis basis_bend(double t) { return {{1 - t, 3 * t - 2, 1 - 3 * t, t}}; }

/// Control points c[0 … n−1]; the motion runs over 1 ≤ u ≤ n−2, u counted in steps. At rest ends three points are equal.
template <int D>
struct MotionWindow {
  using Vec = Eigen::Matrix<double, D, 1>;
  std::vector<Vec> c;
  std::size_t first = 0;     ///< path segment under the tool at the beginning
  std::vector<double> pass;  ///< u at which vertices first+1, first+2, … are passed; never falling
  bool rest_begin = true, rest_end = true;
  std::size_t stride = 1;  ///< steps of the result that one step stands for: 1, 2 or 4

  std::size_t size() const { return c.size(); }
  /// Interval of u and the position in it.
  std::size_t cell(double u, double& t) const {
    const double top = static_cast<double>(c.size()) - 3;
    std::size_t k = static_cast<std::size_t>(std::clamp(std::floor(u), 1.0, top));
    t = u - static_cast<double>(k);
    return k;
  }
  Vec combine(std::size_t k, const Basis& b) const {
    return b.w[0] * c[k - 1] + b.w[1] * c[k] + b.w[2] * c[k + 1] + b.w[3] * c[k + 2];
  }
};

template <int D>
Eigen::Matrix<double, D, 1> vertex(const TubePath& path, std::size_t i) {
  return Eigen::Map<const Eigen::Matrix<double, D, 1>>(path.point(i));
}

}  // namespace toolpace::detail::tube
