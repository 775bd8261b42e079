#pragma once
/// Several corners too close for a blend each: one cubic B-spline whose control polygon is the path.

#include <utility>
#include <vector>

#include "toolpace/path/path.h"

namespace toolpace {

/// Between the trimmed lines before the first and after the last node. The nodes are control points, and, on lines longer
/// than a node's trim, points at the trim's distance, which pull the curve towards the node. Curvature is continuous, zero
/// at the ends; on chords of a smooth curve it hardly changes.
class CornerChain {
 public:
  struct Piece {
    double begin, end;      ///< parameters
    double length;          ///< [mm], relative accuracy 1e-10
    std::uint32_t segment;  ///< of the path, that it replaces
  };

  /// @param path  kept by reference
  /// @param trim  of each node of the path [mm] > 0 for first … last
  CornerChain(const Path& path, std::size_t first, std::size_t last, const std::vector<double>& trim);

  /// Hands the curve over; the chain is worth nothing after that.
  SplineCurve release() { return std::move(curve_); }
  /// Short enough for quadrature, in order.
  std::vector<Piece> cut() const;

  AxisVector point(double parameter) const;

  /// Where a node is passed: the curve's place nearest to it.
  struct Passing {
    double parameter;
    double deviation;  ///< distance of the node to it [mm]
  };
  Passing pass(std::size_t node) const;
  /// Distance of a node to its station on the curve [mm]: no less than the deviation where it is passed, and quickly known.
  double offset(std::size_t node) const;

 private:
  /// The polynomial between two stations.
  struct Span {
    Eigen::Vector3d start, first, second, third;

    Eigen::Vector3d point(double x) const { return start + x * (first + x * (second / 2 + x / 6 * third)); }
    Eigen::Vector3d slope(double x) const { return first + x * (second + x / 2 * third); }
    Eigen::Vector3d bend(double x) const { return second + x * third; }
    double length(double from, double to) const;
  };

  struct Inner;

  Span span(std::size_t k) const;
  /// Of all control points but two at each end; their parameters are 1, 2, …
  std::size_t stations() const { return segment_of_.size(); }
  std::size_t spans() const { return stations() + 1; }
  static void cut_span(const Span& span, const Piece& piece, std::vector<Piece>& pieces);
  void add_control(const Eigen::Vector3d& point, std::size_t segment_before);

  const Path& path_;
  std::size_t first_, last_;
  SplineCurve curve_;
  std::vector<std::uint32_t> segment_of_;  // segment that ends at each station
  std::vector<std::uint32_t> node_at_;     // index of each node's station
};

}  // namespace toolpace
