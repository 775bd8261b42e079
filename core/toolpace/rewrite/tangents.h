#pragma once
/// Which way a curve goes at its vertices, whatever its chords do.

#include <cstddef>
#include <vector>

#include "toolpace/rewrite/curve.h"

namespace toolpace::detail::rewrite {

/// Directions of parabolas by least squares through the points about a vertex: noise evens out, and on curves the third order alone
/// is missed. At barriers each side has its own.
class Tangents {
 public:
  /// @param reach  of each row [mm]: how far on each side points are looked at, at least two
  Tangents(const Curve& curve, std::vector<double> reach);

  /// Of length 1, or 0 where nothing moves.
  Eigen::Vector3d arriving(std::size_t vertex) const;
  Eigen::Vector3d leaving(std::size_t vertex) const;

 private:
  Eigen::Vector3d direction(std::size_t vertex, double back, double on) const;

  const Curve& curve_;
  std::vector<double> reach_;
  std::vector<std::uint32_t> first_, last_;  // points that the barriers before and behind a vertex let be seen
};

}  // namespace toolpace::detail::rewrite
