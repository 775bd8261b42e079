#include "drawing/deviation_trace.h"

#include <algorithm>
#include <cmath>

#include "toolpace/verify/path_follower.h"

namespace toolpace::ui {
namespace {

constexpr double kReachOfTolerance = 1.5;     // where points are looked for
constexpr double kSagittaOfTolerance = 0.02;  // how far a chord may be from its curve
constexpr double kPoints = 100'000;           // about so many along the whole path
constexpr int kMostOfChord = 256;

bool has_turns(const Path& path) {
  return std::any_of(path.node.begin(), path.node.end(),
                     [&](const AxisVector& p) { return p.tail<3>() != path.node.front().tail<3>(); });
}

/// Points of a path, close enough together.
class Points {
 public:
  Points(const Path& path, double sagitta) : vertices_(path, sagitta), step_(length_of(path) / kPoints) {}

  /// Calls take(point) for each until it says no. @return whether it never did
  template <class Take>
  bool for_each(const Take& take) {
    AxisVector from = vertices_.at(0)->point;
    if (!take(from)) return false;
    for (std::size_t k = 1; const PathVertex* vertex = vertices_.at(k); ++k) {
      const AxisVector to = vertex->point;
      const double chord = (to - from).norm();
      const int count = std::clamp(static_cast<int>(chord / std::max(step_, 1e-9)), 1, kMostOfChord);
      for (int i = 1; i <= count; ++i) {
        if (!take(AxisVector(from + (to - from) * (static_cast<double>(i) / count)))) return false;
      }
      from = to;
      vertices_.forget_before(k);
    }
    return true;
  }

 private:
  static double length_of(const Path& path) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < path.node.size(); ++i) sum += (path.node[i + 1] - path.node[i]).norm();
    return sum;
  }

  PathVertices vertices_;
  double step_;
};

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
  return Points(other, sagitta).for_each(take) ? trace : nullptr;
}

}  // namespace toolpace::ui
