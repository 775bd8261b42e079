#include "toolpace/rewrite/fit_smooth.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "toolpace/rewrite/fit_line.h"
#include "toolpace/rewrite/longest.h"
#include "toolpace/rewrite/tangents.h"

namespace toolpace::detail::rewrite {
namespace {

constexpr double kReach = 0.25;           // of the length of a plain block: how far is looked for the direction
constexpr double kSameDirection = 0.01;   // [rad] that a single line or arc may be off the curve's direction
constexpr double kWorthSmooth = 0.5;      // of the rows that a block with corners stands for
constexpr std::size_t kLeastOfBiarc = 5;  // rows

class SmoothFitter {
 public:
  SmoothFitter(const Curve& curve, const FitRules& rules, int plane, const std::vector<Span>& plain)
      : curve_(curve),
        rules_(rules),
        tolerance_(rules.tolerance - curve.sagitta),
        biarcs_(curve, rules.arc, rules.grid, tolerance_),
        plain_(curve, rules, plane),
        plane_of_(curve.rows(), plane),
        tangents_(curve, reach_of(plain)) {
    for (const Span& span : plain) {
      if (span.kind == Span::Kind::arc)
        std::fill(plane_of_.begin() + span.first, plane_of_.begin() + span.last, span.arc.plane);
    }
  }

  std::vector<Span> fit(const Monitor& monitor) {
    std::vector<Span> spans;
    for (std::size_t at = 0; at < curve_.rows() && !monitor.is_cancelled();) {
      if (spans.size() % kSpansAReport == 0)
        monitor.report(static_cast<double>(at) / static_cast<double>(curve_.rows()));
      const std::size_t limit = plain_.next_barrier(at);
      const Span plain = plain_.longest(at, limit), smooth = smoothest(at, limit);
      const Span& span = rows_per_block(smooth) >= kWorthSmooth * rows_per_block(plain) ? smooth : plain;
      at = span.last;
      spans.push_back(span);
    }
    return spans;
  }

 private:
  static double rows_per_block(const Span& span) {
    return static_cast<double>(span.last - span.first) / (span.kind == Span::Kind::biarc ? 2 : 1);
  }

  std::vector<double> reach_of(const std::vector<Span>& plain) const {
    std::vector<double> reach(curve_.rows() + 1, 0.0);
    for (const Span& span : plain) {
      double length = 0.0;
      for (std::size_t k = curve_.vertex[span.first]; k < curve_.vertex[span.last]; ++k)
        length += (curve_.point[k + 1] - curve_.point[k]).norm();
      std::fill(reach.begin() + span.first, reach.begin() + span.last, kReach * length);
    }
    reach.back() = reach[reach.size() - 2];
    return reach;
  }

  /// At a corner there is no direction to keep to.
  bool is_free(std::size_t vertex) const { return curve_.barrier[vertex] != 0; }

  static bool is_along(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return a.dot(b) > 0.0 &&
           a.cross(b).squaredNorm() <= kSameDirection * kSameDirection * a.squaredNorm() * b.squaredNorm();
  }

  /// Whether an arc keeps to the directions at its ends, seen in its plane.
  bool keeps_directions(const FittedArc& arc, std::size_t first, std::size_t last) const {
    const PlaneOfArcs axes(arc.plane);
    Eigen::Vector3d normal = Eigen::Vector3d::Zero(), centre = curve_.at(first);
    normal[axes.normal] = arc.clockwise ? -1.0 : 1.0;
    centre[axes.first] += arc.i;
    centre[axes.second] += arc.j;
    const auto along = [&](std::size_t vertex, Eigen::Vector3d direction) {
      Eigen::Vector3d radial = curve_.at(vertex) - centre;
      radial[axes.normal] = direction[axes.normal] = 0.0;
      return is_along(normal.cross(radial), direction);
    };
    return (is_free(first) || along(first, tangents_.leaving(first))) &&
           (is_free(last) || along(last, tangents_.arriving(last)));
  }

  /// @return a span without rows where none is worth it
  Span smoothest(std::size_t first, std::size_t limit) {
    const int plane = plane_of_[first];
    Span line = RunFitter::span(Span::Kind::line, first, first + 1);
    line.last = static_cast<std::uint32_t>(farthest(first + 1, limit, [&](std::size_t last) {
      const Eigen::Vector3d way = curve_.at(last) - curve_.at(first);
      return fits_line(curve_, first, last, tolerance_) &&
             (is_free(first) || is_along(way, tangents_.leaving(first))) &&
             (is_free(last) || is_along(way, tangents_.arriving(last)));
    }));
    const Span arc = plain_.longest_arc(plane, first, line.last, limit, [&](const FittedArc& found, std::size_t last) {
      return keeps_directions(found, first, last);
    });
    const Span& single = arc.last > line.last ? arc : line;
    const Span biarc = longest_biarc(plane, first, limit);
    const std::size_t rows = biarc.last - first;
    if (rows >= kLeastOfBiarc && rows > 2 * (single.last - first)) return biarc;
    return plain_.is_worth_it(single) ? single : RunFitter::span(Span::Kind::kept, first, first);
  }

  Span longest_biarc(int plane, std::size_t first, std::size_t limit) {
    Span biarc = RunFitter::span(Span::Kind::biarc, first, first + 1);
    const PlaneOfArcs axes(plane);
    const auto named = [&](Eigen::Index axis) { return rules_.named[static_cast<std::size_t>(axis)]; };
    const std::size_t from = std::max(named(axes.first), named(axes.second));
    biarc.last = static_cast<std::uint32_t>(farthest(first + 1, limit, [&](std::size_t last) {
      if (from >= last) return false;
      const auto found = biarcs_.fit(plane, first, last, tangents_.leaving(first), tangents_.arriving(last));
      if (!found) return false;
      biarc.arc = found->first;
      biarc.second = found->second;
      biarc.joint = found->joint;
      return true;
    }));
    return biarc;
  }

  const Curve& curve_;
  const FitRules& rules_;
  double tolerance_;
  BiarcFitter biarcs_;
  RunFitter plain_;
  std::vector<int> plane_of_;
  Tangents tangents_;
};

}  // namespace

std::vector<Span> fit_smooth(const Curve& curve, const FitRules& rules, int plane, const std::vector<Span>& plain,
                             const Monitor& monitor) {
  return SmoothFitter(curve, rules, plane, plain).fit(monitor);
}

}  // namespace toolpace::detail::rewrite
