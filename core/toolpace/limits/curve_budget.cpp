#include "toolpace/limits/curve_budget.h"

#include <algorithm>
#include <cmath>

#include "toolpace/path/curve_sampler.h"

namespace toolpace {
namespace {

// Shares of an axis' limits that the curvature may take at most. The rest is left to change the speed with; at 0.9 of
// the acceleration a circle still speeds up with √(1 − 0.9²) = 44 % of it.
constexpr double kCentripetalShare = 0.9;
constexpr double kCentripetalJerkShare = 0.5;
constexpr int kSplineSamples = 9;
constexpr int kBlendSamples = 33;  // at sharp corners curvature changes fast, beside the middle
constexpr double kSplineMargin = 1.02;

/// The largest component along an axis of a vector that turns with the arc and keeps its part along the arc's normal.
double turned(const ArcCurve& arc, const AxisVector& vector, int axis) {
  const Eigen::Vector3d v = vector.head<3>();
  return std::hypot(v.dot(arc.radial), v.dot(arc.lateral)) * std::hypot(arc.radial[axis], arc.lateral[axis]) +
         std::abs(arc.normal[axis] * v.dot(arc.normal));
}

CurveBounds arc_bounds(const Path& path, std::size_t i) {
  // At mid-arc the radius is the mean one; spirals are bounded at both ends. On helical ones the slope changes, too.
  CurveBounds bounds{AxisVector::Zero(), AxisVector::Zero(), AxisVector::Zero()};
  const ArcCurve& arc = path.arcs[path.detail[i]];
  for (const double s : {0.0, path.length[i]}) {
    const Frame f = frame_at(path, i, s);
    for (int axis = 0; axis < 3; ++axis) {
      bounds.first[axis] = std::max(bounds.first[axis], turned(arc, f.first, axis));
      bounds.second[axis] = std::max(bounds.second[axis], turned(arc, f.second, axis));
      bounds.third[axis] = std::max(bounds.third[axis], turned(arc, f.third, axis));
    }
    bounds.first.tail<3>() = bounds.first.tail<3>().cwiseMax(f.first.tail<3>().cwiseAbs());
    bounds.second.tail<3>() = bounds.second.tail<3>().cwiseMax(f.second.tail<3>().cwiseAbs());
    bounds.third.tail<3>() = bounds.third.tail<3>().cwiseMax(f.third.tail<3>().cwiseAbs());
  }
  return bounds;
}

CurveBounds sampled_bounds(const Path& path, std::size_t i) {
  CurveBounds bounds{AxisVector::Zero(), AxisVector::Zero(), AxisVector::Zero()};
  const int samples = path.kind[i] == SegmentKind::blend ? kBlendSamples : kSplineSamples;
  const CurveSampler curve(path, i);
  for (int k = 0; k < samples; ++k) {
    const ParameterDerivatives f = curve.at_share(static_cast<double>(k) / (samples - 1));
    bounds.first = bounds.first.cwiseMax(f.first.cwiseAbs());
    bounds.second = bounds.second.cwiseMax(f.second.cwiseAbs());
    bounds.third = bounds.third.cwiseMax(f.third.cwiseAbs());
  }
  return {bounds.first * kSplineMargin, bounds.second * kSplineMargin, bounds.third * kSplineMargin};
}

}  // namespace

CurveBounds curve_bounds(const Path& path, std::size_t i) {
  switch (path.kind[i]) {
    case SegmentKind::line: {
      const AxisVector u = (path.node[i + 1] - path.node[i]) / path.length[i];
      return {u.cwiseAbs(), AxisVector::Zero(), AxisVector::Zero()};
    }
    case SegmentKind::arc: return arc_bounds(path, i);
    default: return sampled_bounds(path, i);
  }
}

CurveBudget curve_budget(const CurveBounds& b, const std::array<AxisLimits, kAxisCount>& axes, double speed_wanted) {
  CurveBudget budget{speed_wanted, kUnlimited, kUnlimited, false};
  const auto cap = [&](double speed, bool is_curvature) {
    if (speed < budget.speed) {
      budget.speed = speed;
      budget.is_curvature = is_curvature;
    }
  };
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    if (b.first[i] > 0) cap(axes[k].speed / b.first[i], false);
    if (b.second[i] > 0) cap(std::sqrt(kCentripetalShare * axes[k].acceleration / b.second[i]), true);
    if (b.third[i] > 0) cap(std::cbrt(kCentripetalJerkShare * axes[k].jerk / b.third[i]), true);
  }
  const double v = budget.speed;
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    if (b.first[i] <= 0 || !(axes[k].acceleration < kUnlimited)) continue;
    const double centripetal = b.second[i] > 0 ? b.second[i] * v * v : 0.0;
    budget.acceleration = std::min(budget.acceleration, (axes[k].acceleration - centripetal) / b.first[i]);
  }
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    if (!(axes[k].jerk < kUnlimited) || (b.first[i] <= 0 && b.second[i] <= 0)) continue;
    const double left = axes[k].jerk - (b.third[i] > 0 ? b.third[i] * v * v * v : 0.0);
    // Half of what is left for the turning acceleration 3κva, half for the jerk along the path.
    if (b.second[i] > 0 && v > 0) {
      budget.acceleration = std::min(budget.acceleration, left / 2 / (3 * b.second[i] * v));
    }
  }
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    if (!(axes[k].jerk < kUnlimited) || b.first[i] <= 0) continue;
    double left = axes[k].jerk;
    if (b.third[i] > 0) left -= b.third[i] * v * v * v;
    if (b.second[i] > 0) left -= 3 * b.second[i] * v * budget.acceleration;
    budget.jerk = std::min(budget.jerk, left / b.first[i]);
  }
  return budget;
}

}  // namespace toolpace
