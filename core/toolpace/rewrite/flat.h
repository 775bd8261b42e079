#pragma once
/// Points seen in a plane of arcs.

#include <Eigen/Core>
#include <cmath>
#include <vector>

namespace toolpace::detail::rewrite {

/// Along a plane's first and second axis, and along its normal [mm].
struct Flat {
  double u = 0.0, v = 0.0, w = 0.0;
};
inline Flat operator-(const Flat& a, const Flat& b) { return {a.u - b.u, a.v - b.v, a.w - b.w}; }
inline double cross(const Flat& a, const Flat& b) { return a.u * b.v - a.v * b.u; }
inline double dot(const Flat& a, const Flat& b) { return a.u * b.u + a.v * b.v; }

/// Axes of G17, G18, G19, right-handed.
struct PlaneOfArcs {
  explicit PlaneOfArcs(int plane = 17)
      : first(plane == 17   ? 0
              : plane == 18 ? 2
                            : 1),
        second((first + 1) % 3),
        normal((first + 2) % 3) {}
  Flat flat(const Eigen::Vector3d& p) const { return {p[first], p[second], p[normal]}; }

  Eigen::Index first, second, normal;
};

using FlatPoints = std::vector<Flat>;

}  // namespace toolpace::detail::rewrite
