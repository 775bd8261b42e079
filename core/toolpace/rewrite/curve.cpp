#include "toolpace/rewrite/curve.h"

#include <algorithm>
#include <cmath>

#include "toolpace/path/arc.h"

namespace toolpace::detail::rewrite {
namespace {

constexpr double kSagitta = 0.05;     // of the tolerance
constexpr double kMostChords = 4096;  // of one arc

/// Adds the places of an arc between its ends. @return whether it is one that may be replaced
bool add_arc(const Moves& moves, std::size_t row, double sagitta, std::vector<Eigen::Vector3d>& points) {
  const ArcCurve arc = make_arc(moves.begin_of(row), moves.end[row], moves.arcs[moves.detail[row]]);
  const double radius = std::max(arc.start_radius, arc.end_radius);
  const double chords = std::ceil(arc.sweep * std::sqrt(radius / (8 * sagitta)));
  if (!(chords <= kMostChords)) return false;
  for (double k = 1; k < chords; ++k) points.push_back(arc_point(arc, arc.sweep * (k / chords)).head<3>());
  return true;
}

/// The place on the chain `reach` before or behind a vertex, or where the run ends or a barrier stands.
Eigen::Vector3d place_beside(const Curve& curve, std::size_t vertex, double reach, bool behind) {
  std::size_t at = curve.vertex[vertex];
  const std::size_t end = behind ? curve.point.size() - 1 : 0;
  while (at != end) {
    const std::size_t next = behind ? at + 1 : at - 1;
    const Eigen::Vector3d way = curve.point[next] - curve.point[at];
    const double length = way.norm();
    if (length >= reach) return curve.point[at] + way * (reach / length);
    reach -= length;
    at = next;
  }
  return curve.point[end];
}

/// Whether the turn from `in` to `out` is over kCornerTurn; ways without length turn nowhere.
bool turns(const Eigen::Vector3d& in, const Eigen::Vector3d& out) {
  const double dot = in.dot(out), square = in.squaredNorm() * out.squaredNorm();
  static const double kCosine = std::cos(kCornerTurn);
  if (square == 0.0) return false;
  return dot < 0.0 || dot * dot < kCosine * kCosine * square;
}

bool is_corner(const Curve& curve, std::size_t vertex, double tolerance) {
  const std::size_t at = curve.vertex[vertex];
  const Eigen::Vector3d& here = curve.point[at];
  if (!turns(here - curve.point[at - 1], curve.point[at + 1] - here)) return false;
  const double reach = kCornerReach * tolerance;
  return turns(here - place_beside(curve, vertex, reach, false), place_beside(curve, vertex, reach, true) - here);
}

}  // namespace

void make_curve(const Moves& moves, const Run& run, double tolerance, Curve& curve) {
  curve.point.clear();
  curve.vertex.clear();
  curve.barrier.assign(run.count + 1, 0);
  curve.is_arc.assign(run.count, 0);
  curve.sagitta = 0.0;
  curve.point.push_back(moves.begin_of(run.row).head<3>());
  curve.vertex.push_back(0);
  for (std::size_t k = 0; k < run.count; ++k) {
    const std::size_t row = run.row + k;
    if (moves.kind[row] == MoveKind::arc) {
      curve.is_arc[k] = 1;
      curve.sagitta = kSagitta * tolerance;
      if (!add_arc(moves, row, curve.sagitta, curve.point)) curve.barrier[k] = curve.barrier[k + 1] = 1;
    }
    curve.point.push_back(moves.end[row].head<3>());
    curve.vertex.push_back(static_cast<std::uint32_t>(curve.point.size() - 1));
    if (k > 0 && moves.feed[row] != moves.feed[row - 1]) curve.barrier[k] = 1;
  }
  for (std::size_t k = 1; k < run.count; ++k) {
    if (curve.barrier[k] == 0 && is_corner(curve, k, tolerance)) curve.barrier[k] = 1;
  }
  curve.barrier.front() = curve.barrier.back() = 1;
}

}  // namespace toolpace::detail::rewrite
