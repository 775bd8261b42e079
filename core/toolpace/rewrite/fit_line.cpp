#include "toolpace/rewrite/fit_line.h"

#include <algorithm>

namespace toolpace::detail::rewrite {

bool fits_line(const Curve& curve, std::size_t first, std::size_t last, double tolerance) {
  const Eigen::Vector3d start = curve.at(first), way = curve.at(last) - start;
  const double square = way.squaredNorm(), most = tolerance * tolerance;
  const double per_length = square > 0.0 ? 1.0 / square : 0.0;
  double share = 0.0;
  // Both are straight from one point to the next, so that distances between are no larger than those at the points.
  for (std::size_t k = curve.vertex[first] + 1; k < curve.vertex[last]; ++k) {
    const Eigen::Vector3d from_start = curve.point[k] - start;
    share = std::min(1.0, std::max(share, from_start.dot(way) * per_length));
    if ((from_start - share * way).squaredNorm() > most) return false;
  }
  return true;
}

}  // namespace toolpace::detail::rewrite
