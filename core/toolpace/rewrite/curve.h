#pragma once
/// The geometry of a run as a chain of points, which replacements are held against.

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "toolpace/nc/moves.h"
#include "toolpace/rewrite/runs.h"

namespace toolpace::detail::rewrite {

/// Straight chords from point to point. Ends of rows are points, arcs have more between.
struct Curve {
  std::vector<Eigen::Vector3d> point;  ///< [mm]
  std::vector<std::uint32_t> vertex;   ///< point where row k of the run begins, and behind the last one its end
  std::vector<std::uint8_t> barrier;   ///< of each vertex: no replacement goes on across it
  std::vector<std::uint8_t> is_arc;    ///< of each row
  double sagitta = 0.0;                ///< [mm] at most how far an arc is from its chords

  std::size_t rows() const { return vertex.size() - 1; }
  const Eigen::Vector3d& at(std::size_t vertex_index) const { return point[vertex[vertex_index]]; }
};

/// A corner stays a corner: a vertex whose own two chords turn by more than kCornerTurn, and where the path as a whole turns by
/// more than that, too, from the place kCornerReach tolerances before it to the one as far behind it. The second test tells
/// corners from noise, the first one from curves.
inline constexpr double kCornerTurn = 0.5235987755982988;  ///< [rad] 30 degrees
inline constexpr double kCornerReach = 10.0;               ///< [tolerances]

/// Barriers are corners, and places where the feed changes. Rows whose arcs take more than a few thousand chords stand between
/// barriers.
void make_curve(const Moves& moves, const Run& run, double tolerance, Curve& curve);

}  // namespace toolpace::detail::rewrite
