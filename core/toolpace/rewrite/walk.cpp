#include "toolpace/rewrite/walk.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "toolpace/path/build_path.h"
#include "toolpace/verify/path_follower.h"

namespace toolpace::detail::rewrite {
namespace {

constexpr double kChordSagitta = 1.0 / 500;  // [tolerances] of chords that stand for arcs
constexpr double kExact = 0.01;              // [tolerances]

Moves rows_of(const MoveRows& stretch) {
  const Moves& all = stretch.moves;
  Moves some;
  some.start = all.begin_of(stretch.first);
  const auto copy = [&](const auto& from, auto& to) {
    to.assign(from.begin() + static_cast<std::ptrdiff_t>(stretch.first),
              from.begin() + static_cast<std::ptrdiff_t>(stretch.last));
  };
  copy(all.kind, some.kind);
  copy(all.line, some.line);
  copy(all.file, some.file);
  copy(all.end, some.end);
  copy(all.feed, some.feed);
  some.mode.assign(some.kind.size(), 0);
  for (std::size_t row = stretch.first; row < stretch.last; ++row) {
    some.detail.push_back(kNoDetail);
    if (all.kind[row] != MoveKind::arc) continue;
    some.detail.back() = static_cast<std::uint32_t>(some.arcs.size());
    some.arcs.push_back(all.arcs[all.detail[row]]);
  }
  return some;
}

/// Points along a path whose chords are within a distance of it.
std::vector<AxisVector> points_of(const Path& path, double sagitta) {
  std::vector<AxisVector> points = {path.node.front()};
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (path.kind[i] == SegmentKind::arc) {
      const ArcCurve& arc = path.arcs[path.detail[i]];
      const double radius = std::max(arc.start_radius, arc.end_radius);
      const double chords = std::ceil(arc.sweep * std::sqrt(radius / (8 * sagitta)));
      for (double k = 1; k < chords; ++k) points.push_back(point_at(path, i, path.length[i] * (k / chords)));
    }
    points.push_back(path.node[i + 1]);
  }
  return points;
}

bool walks(const std::vector<AxisVector>& points, const Path& path, double within) {
  PathVertices vertices(path, kOnPath, {});
  PathFollower follower(vertices, within, false);
  if (!follower.start(points.front())) return false;
  for (std::size_t k = 1; k < points.size(); ++k) {
    if (!follower.advance(points[k - 1], points[k], {})) return false;
  }
  return follower.reaches_end();
}

}  // namespace

WalkMeter::WalkMeter(double tolerance) : tolerance_(tolerance), largest_(std::min(kOnPath, tolerance)) {}

bool WalkMeter::take(const MoveRows& before, const MoveRows& after) {
  const auto from = build_path(rows_of(before), 0.0), to = build_path(rows_of(after), 0.0);
  if (!from || !to) return false;
  if (from->size() == 0 && to->size() == 0) return true;
  if (from->size() == 0 || to->size() == 0) return false;
  const double sagitta = kChordSagitta * tolerance_;
  const std::vector<AxisVector> points = points_of(*from, sagitta);
  const double chords = points.size() == from->node.size() ? 0.0 : sagitta;
  const auto fits = [&](double distance) { return distance > chords && walks(points, *to, distance - chords); };
  if (fits(largest_)) return true;
  if (!fits(tolerance_)) return false;
  double low = largest_, high = tolerance_;
  while (high - low > kExact * tolerance_) {
    const double middle = (low + high) / 2;
    (fits(middle) ? high : low) = middle;
  }
  largest_ = high;
  return true;
}

}  // namespace toolpace::detail::rewrite
