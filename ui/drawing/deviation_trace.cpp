#include "drawing/deviation_trace.h"

#include <algorithm>
#include <cmath>

#include "toolpace/verify/path_follower.h"

namespace toolpace::ui {
namespace {

constexpr double kReachOfTolerance = 1.5;     // where points are looked for
constexpr double kSagittaOfTolerance = 0.02;  // how far a chord may be from its curve
constexpr double kPoints = 100'000;           // about so many along the whole path
constexpr int kMostOfSegment = 8192;

bool has_turns(const Path& path) {
  return std::any_of(path.node.begin(), path.node.end(),
                     [&](const AxisVector& p) { return p.tail<3>() != path.node.front().tail<3>(); });
}

/// Calls take(point) for places along a path that are close enough together, until it says no. @return whether it never did
template <class Take>
bool for_each_point(const Path& path, const Take& take) {
  double length = 0;
  for (const double one : path.length) length += one;
  const double step = std::max(length / kPoints, 1e-9);
  if (!take(weighted(path.node.front()))) return false;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const int count = std::clamp(static_cast<int>(path.length[i] / step), 1, kMostOfSegment);
    for (int k = 1; k < count; ++k) {
      if (!take(weighted(point_at(path, i, path.length[i] * k / count)))) return false;
    }
    if (!take(weighted(path.node[i + 1]))) return false;
  }
  return true;
}

}  // namespace

std::shared_ptr<const ErrorTrace> make_deviation_trace(const Path& path, const Path& other, double tolerance,
                                                       const Monitor& monitor) {
  if (path.size() == 0 || other.size() == 0) return nullptr;
  const double reach = kReachOfTolerance * tolerance, sagitta = kSagittaOfTolerance * tolerance;
  PathVertices vertices(path, sagitta);
  PathFollower follower(vertices, reach, has_turns(path));
  auto trace = std::make_shared<ErrorTrace>();
  AxisVector last = AxisVector::Zero();
  const auto take = [&](const AxisVector& point) {
    if (monitor.is_cancelled()) return false;
    const bool follows = trace->time.empty() ? follower.start(point) : follower.advance(last, point, {reach, reach});
    last = point;
    if (!follows) return false;
    const PathMatch& match = follower.match();
    const bool inside = vertices.at(match.cell + 1) != nullptr;
    const AxisVector foot = inside ? vertices.point(match.cell, match.t) : vertices.at(match.cell)->point;
    trace->time.push_back(static_cast<double>(trace->time.size()));
    trace->commanded.push_back(foot.head<3>().cast<float>());
    trace->offset.push_back((point - foot).head<3>().cast<float>());
    trace->error.push_back(trace->offset.back().norm());
    return true;
  };
  return for_each_point(other, take) ? trace : nullptr;
}

}  // namespace toolpace::ui
