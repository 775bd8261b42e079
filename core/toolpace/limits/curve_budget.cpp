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

// Pieces of splines are short; at sharp corners curvature changes fast, beside the middle.
constexpr int kSplineStretches = 1, kBlendStretches = 4;
constexpr int kMostHalvings = 6;          // of a stretch: enough but where the curve has a cusp
constexpr double kRise = 0.05;            // between samples, that is added rather than looked for
constexpr double kMinorRise = 0.01;       // as a part of the axis that has most
constexpr double kNoTurn = 1e-9;          // change of direction over a segment that is rounding
constexpr double kCuspRise = 0.1;         // added where halving does not settle it
constexpr double kSampledMargin = 1.004;  // for derivatives that change faster than second differences tell

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

/// Largest magnitudes of sampled functions. Between equal steps a function rises above the line through two samples by an
/// eighth of its second difference at most, as far as that is constant; its change is added. Stretches in which a function
/// may rise above its largest sample by more than a small part are halved, the others are done.
/// @tparam rows  axes: X Y Z, or all
template <int rows>
class PeakSearch {
 public:
  using Values = Eigen::Array<double, rows, 3>;  // first, second and third derivative

  PeakSearch(const CurveSampler& curve, double length)
      : curve_(curve), least_(0.0, kNoTurn / length, kNoTurn / (length * length)) {}

  /// @param begin, end  of the whole curve
  CurveBounds run(const ParameterDerivatives& begin, const ParameterDerivatives& end, int stretches) {
    const double width = 1.0 / stretches;
    Values from = values(begin);
    for (int k = 0; k < stretches; ++k) {
      const Values to = k + 1 == stretches ? values(end) : sample((k + 1) * width);
      search({k * width, width, from, sample((k + 0.5) * width), to}, kMostHalvings);
      from = to;
    }
    return bounds();
  }

 private:
  struct Stretch {
    double from, width;
    Values begin, middle, end;
  };

  CurveBounds bounds() const {
    CurveBounds b{AxisVector::Zero(), AxisVector::Zero(), AxisVector::Zero()};
    b.first.head<rows>() = upper_.col(0) * kSampledMargin;
    b.second.head<rows>() = upper_.col(1) * kSampledMargin;
    b.third.head<rows>() = upper_.col(2) * kSampledMargin;
    b.first.head<3>() = b.first.head<3>().cwiseMin(1.0);
    return b;
  }

  template <int all>
  static Values values(const CurveDerivatives<all>& d) {
    Values v;
    v.col(0) = d.first.template head<rows>();
    v.col(1) = d.second.template head<rows>();
    v.col(2) = d.third.template head<rows>();
    return v;
  }
  Values sample(double share) const { return values(curve_.at_share<rows>(share)); }

  void search(const Stretch& s, int halvings) {
    const Values left = sample(s.from + s.width / 4), right = sample(s.from + 3 * s.width / 4);
    const Values most = s.begin.abs().max(s.end.abs()).max(s.middle.abs()).max(left.abs()).max(right.abs());
    largest_ = largest_.max(most);
    const Values bend[] = {s.begin - 2 * left + s.middle, left - 2 * s.middle + right, s.middle - 2 * right + s.end};
    const Values high = bend[0].max(bend[1]).max(bend[2]), low = bend[0].min(bend[1]).min(bend[2]);
    const Values top = most + (high.max(-low) + (high - low)) / 8;
    if ((top <= allowed()).all()) {
      upper_ = upper_.max(top);
    } else if (halvings == 0) {
      upper_ = upper_.max(top.min((1 + kCuspRise) * most));
    } else {
      search({s.from, s.width / 2, s.begin, left, s.middle}, halvings - 1);
      search({s.from + s.width / 2, s.width / 2, s.middle, right, s.end}, halvings - 1);
    }
  }

  /// What a stretch may reach without being halved.
  Values allowed() const {
    Values a = (1 + kRise) * largest_;
    for (Eigen::Index order = 0; order < 3; ++order) {
      for (Eigen::Index axis = 0; axis < rows; axis += 3) {
        const auto most = largest_.template block<3, 1>(axis, order);
        const double minor = std::max(kMinorRise * most.maxCoeff(), least_[order]);
        a.template block<3, 1>(axis, order) = a.template block<3, 1>(axis, order).max(most + minor);
      }
    }
    return a;
  }

  const CurveSampler& curve_;
  Eigen::Vector3d least_;
  Values largest_ = Values::Zero();  // of the samples
  Values upper_ = Values::Zero();    // of the stretches that are done
};

bool turns(const ParameterDerivatives& d) {
  return !d.first.tail<3>().isZero(0.0) || !d.second.tail<3>().isZero(0.0) || !d.third.tail<3>().isZero(0.0);
}

CurveBounds sampled_bounds(const Path& path, std::size_t i) {
  const CurveSampler curve(path, i);
  const int stretches = path.kind[i] == SegmentKind::spline ? kSplineStretches : kBlendStretches;
  const ParameterDerivatives begin = curve.at_share(0.0), end = curve.at_share(1.0);
  // Rotary axes run as polynomials of degree 5 at most: if three derivatives are zero at both ends, they stand still.
  if (!turns(begin) && !turns(end)) return PeakSearch<3>(curve, path.length[i]).run(begin, end, stretches);
  return PeakSearch<kAxisCount>(curve, path.length[i]).run(begin, end, stretches);
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
