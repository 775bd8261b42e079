#include "toolpace/path/corner_chain.h"

#include <algorithm>
#include <cmath>

namespace toolpace {
namespace {

constexpr double kGentleTurn = 0.6;  // 2·sin(α/2) up to which one quadrature a span will do
constexpr int kSharpPieces = 4;
constexpr double kNearEnough = 0.8;  // of a line: a trim longer than this needs no control point of its own

Eigen::Vector4d homogeneous(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z(), 1.0}; }

Eigen::Vector3d direction(const Path& path, std::size_t segment) {
  return (path.node[segment + 1] - path.node[segment]).head<3>() / path.length[segment];
}

}  // namespace

CornerChain::CornerChain(const Path& path, std::size_t first, std::size_t last, const std::vector<double>& trim)
    : first_(first), curve_{3, {}, {}, path.node[first], path.node[first]} {
  const Eigen::Vector3d begin = path.node[first].head<3>(), end = path.node[last].head<3>();
  const Eigen::Vector3d before = trim[first] * direction(path, first - 1), after = trim[last] * direction(path, last);
  curve_.points = {homogeneous(begin - before), homogeneous(begin - before * (2.0 / 3))};
  for (std::size_t i = first; i <= last; ++i) {
    if (i > first) add_inner(path, i - 1, trim);
    const Eigen::Vector3d p = path.node[i].head<3>();
    add_control(p, i - 1);
    node_at_.push_back(stations_.size() - 1);
    node_.push_back(p);
  }
  curve_.points.push_back(homogeneous(end + after * (2.0 / 3)));
  curve_.points.push_back(homogeneous(end + after));
  const double top = stations_.back() + 1;
  curve_.knots.assign(4, 0.0);
  curve_.knots.insert(curve_.knots.end(), stations_.begin(), stations_.end());
  curve_.knots.insert(curve_.knots.end(), 4, top);
  cut(path, last);
}

/// Equal knot intervals: a node is then missed by a third of its height over its neighbours, whatever their distances.
void CornerChain::add_control(const Eigen::Vector3d& point, std::size_t segment_before) {
  stations_.push_back(stations_.empty() ? 1.0 : stations_.back() + 1);
  segment_of_.push_back(segment_before);
  curve_.points.push_back(homogeneous(point));
}

/// Control points inside a line of the chain, where a node wants one nearer than the next node.
void CornerChain::add_inner(const Path& path, std::size_t segment, const std::vector<double>& trim) {
  const double length = path.length[segment], left = trim[segment], right = trim[segment + 1];
  const Eigen::Vector3d a = path.node[segment].head<3>(), u = direction(path, segment);
  const auto add = [&](double at) { add_control(a + at * u, segment); };
  // A point next to a node would make a tiny span of high curvature change; a little more distance is mended by the fit.
  const bool from_left = left < kNearEnough * length, from_right = right < kNearEnough * length;
  if (from_left && from_right && left + right > kNearEnough * length) {
    add(length * left / (left + right));
    return;
  }
  if (from_left) add(left);
  if (from_right) add(length - right);
}

void CornerChain::cut(const Path& path, std::size_t last) {
  double from = 0;
  for (std::size_t k = 0; k <= stations_.size(); ++k) {
    const double to = k < stations_.size() ? stations_[k] : curve_.knots.back();
    const std::size_t segment = k < stations_.size() ? segment_of_[k] : last;
    // The nodes at either end of the segment decide how finely.
    double turn = 0;
    for (const std::size_t i : {segment, segment + 1}) {
      if (i >= first_ && i <= last) turn = std::max(turn, (direction(path, i) - direction(path, i - 1)).norm());
    }
    const int parts = turn <= kGentleTurn ? 1 : kSharpPieces;
    for (int q = 0; q < parts; ++q) {
      pieces_.push_back(
          {q == 0 ? from : pieces_.back().end, q + 1 == parts ? to : from + (to - from) * (q + 1) / parts, segment});
    }
    from = to;
  }
}

double CornerChain::passing(std::size_t node) const {
  const std::size_t at = node_at_[node - first_];
  const Eigen::Vector3d& p = node_[node - first_];
  const double low = at > 0 ? stations_[at - 1] : 0,
               high = at + 1 < stations_.size() ? stations_[at + 1] : curve_.knots.back();
  double t = stations_[at], best = t, least = 1e300;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d e = spline_point(curve_, t).head<3>() - p;
    if (e.norm() < least) {
      least = e.norm();
      best = t;
    }
    const ParameterDerivatives d = spline_derivatives(curve_, t);
    const double slope = d.first.head<3>().squaredNorm() + std::max(0.0, e.dot(d.second.head<3>()));
    if (!(slope > 0)) break;
    t = std::clamp(t - e.dot(d.first.head<3>()) / slope, low, high);
  }
  return best;
}

double CornerChain::deviation(std::size_t node) const {
  return (spline_point(curve_, passing(node)).head<3>() - node_[node - first_]).norm();
}

}  // namespace toolpace
