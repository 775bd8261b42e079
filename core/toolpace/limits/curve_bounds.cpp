#include "toolpace/limits/curve_bounds.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "toolpace/limits/peak_search.h"
#include "toolpace/limits/tip_bounds.h"
#include "toolpace/path/curve_sampler.h"

namespace toolpace {
namespace {

// Pieces of splines are short; at sharp corners curvature changes fast, beside the middle.
constexpr int kSplineStretches = 1, kBlendStretches = 4;

/// The largest component along an axis, over an arc of that sweep, of a vector that turns with it and keeps its part along
/// the arc's normal.
double turned(const ArcCurve& arc, const AxisVector& vector, int axis) {
  const Eigen::Vector3d v = vector.head<3>();
  const double out = v.dot(arc.radial), along = v.dot(arc.lateral), steady = arc.normal[axis] * v.dot(arc.normal);
  const double cosine = out * arc.radial[axis] + along * arc.lateral[axis];
  const double sine = out * arc.lateral[axis] - along * arc.radial[axis];
  const auto at = [&](double angle) { return std::abs(cosine * std::cos(angle) + sine * std::sin(angle) + steady); };
  double most = std::max(at(0.0), at(arc.sweep));
  const double amplitude = std::hypot(cosine, sine);
  if (amplitude == 0) return most;
  double highest = std::atan2(sine, cosine), lowest = highest + std::numbers::pi;
  if (highest < 0) highest += kTwoPi;
  if (lowest >= kTwoPi) lowest -= kTwoPi;
  if (highest <= arc.sweep) most = std::max(most, std::abs(steady + amplitude));
  if (lowest <= arc.sweep) most = std::max(most, std::abs(steady - amplitude));
  return most;
}

/// Largest share of an axis in a vector along a helix and one across it, together: √(T² + N²). With c the share of the plane
/// in the direction and s that of the normal, T = c·p·cos φ + s·n and N = p·sin φ.
double share_of_plane(const ArcCurve& arc, double in_plane, int axis) {
  const double p = std::hypot(arc.radial[axis], arc.lateral[axis]);
  const double s = std::sqrt(std::max(0.0, 1 - in_plane * in_plane)), rise = s * std::abs(arc.normal[axis]);
  const double level = in_plane * p + rise;
  double most = std::max(level * level, p * p + rise * rise);
  const double cosine = in_plane * rise / (p * s * s);  // where the derivative by φ is zero
  if (p > 0 && s > 0 && cosine < 1) {
    const double along = in_plane * p * cosine + rise;
    most = std::max(most, along * along + p * p * (1 - cosine * cosine));
  }
  return std::min(1.0, std::sqrt(most));
}

/// The same derivatives as they would be at the arc's start.
void turn_back(const ArcCurve& arc, Frame& frame) {
  const Eigen::AngleAxisd back(-arc.sweep, arc.normal);
  for (AxisVector* d : {&frame.first, &frame.second, &frame.third}) {
    d->head<3>() = (back * Eigen::Vector3d(d->head<3>())).eval();
  }
}

CurveBounds arc_bounds(const Path& path, std::size_t i) {
  // Spirals are bounded at both ends. On helical ones the slope changes, too.
  CurveBounds bounds;
  bounds.together.setZero();
  const ArcCurve& arc = path.arcs[path.detail[i]];
  for (const double s : {0.0, path.length[i]}) {
    if (s > 0 && arc.end_radius == arc.start_radius) break;
    Frame f = frame_at(path, i, s);
    if (s > 0) turn_back(arc, f);
    const double rise = arc.normal.dot(f.first.head<3>()), level = std::sqrt(std::max(0.0, 1 - rise * rise));
    for (int axis = 0; axis < 3; ++axis) {
      bounds.first[axis] = std::max(bounds.first[axis], turned(arc, f.first, axis));
      bounds.second[axis] = std::max(bounds.second[axis], turned(arc, f.second, axis));
      bounds.third[axis] = std::max(bounds.third[axis], turned(arc, f.third, axis));
      bounds.together[axis] = std::max(bounds.together[axis], share_of_plane(arc, level, axis));
    }
    bounds.curvature = std::max(bounds.curvature, f.second.head<3>().norm());
    bounds.bend = std::max(bounds.bend, f.third.head<3>().norm() / level);
    bounds.first.tail<3>() = bounds.first.tail<3>().cwiseMax(f.first.tail<3>().cwiseAbs());
    bounds.second.tail<3>() = bounds.second.tail<3>().cwiseMax(f.second.tail<3>().cwiseAbs());
    bounds.third.tail<3>() = bounds.third.tail<3>().cwiseMax(f.third.tail<3>().cwiseAbs());
  }
  return bounds;
}

bool turns(const ParameterDerivatives& d) {
  return !d.first.tail<3>().isZero(0.0) || !d.second.tail<3>().isZero(0.0) || !d.third.tail<3>().isZero(0.0);
}

CurveBounds sampled_bounds(const Path& path, std::size_t i) {
  const CurveSampler curve(path, i);
  const int stretches = path.kind[i] == SegmentKind::spline ? kSplineStretches : kBlendStretches;
  const ParameterDerivatives begin = curve.at_share(0.0), end = curve.at_share(1.0);
  // Rotary axes run as polynomials of degree 5 at most: if three derivatives are zero at both ends, they stand still.
  CurveBounds b = !turns(begin) && !turns(end)
                      ? PeakSearch<3, CurveSampler>(curve, path.length[i]).run(begin, end, stretches)
                      : PeakSearch<kAxisCount, CurveSampler>(curve, path.length[i]).run(begin, end, stretches);
  b.first.head<3>() = b.first.head<3>().cwiseMin(1.0);
  b.curvature = b.second.head<3>().norm();
  return b;
}

}  // namespace

CurveBounds curve_bounds(const Path& path, std::size_t i) {
  if (path.chain_of(i) != nullptr) return tip_bounds(path, i);
  switch (path.kind[i]) {
    case SegmentKind::line: {
      const AxisVector u = (path.end_of(i) - path.node[i]) / path.length[i];
      CurveBounds bounds;
      bounds.first = u.cwiseAbs();
      return bounds;
    }
    case SegmentKind::arc: return arc_bounds(path, i);
    default: return sampled_bounds(path, i);
  }
}

}  // namespace toolpace
