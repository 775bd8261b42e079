#include "toolpace/limits/curve_bounds.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "toolpace/path/curve_sampler.h"

namespace toolpace {
namespace {

// Pieces of splines are short; at sharp corners curvature changes fast, beside the middle.
constexpr int kSplineStretches = 1, kBlendStretches = 4;
constexpr int kMostHalvings = 6;          // of a stretch: enough but where the curve has a cusp
constexpr double kRise = 0.05;            // between samples, that is added rather than looked for
constexpr double kMinorRise = 0.01;       // as a part of the axis that has most
constexpr double kNoTurn = 1e-9;          // change of direction over a segment that is rounding
constexpr double kCuspRise = 0.1;         // added where halving does not settle it
constexpr double kSampledMargin = 1.004;  // for derivatives that change faster than second differences tell

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
    CurveBounds b;
    b.first.head<rows>() = upper_.col(0) * kSampledMargin;
    b.second.head<rows>() = upper_.col(1) * kSampledMargin;
    b.third.head<rows>() = upper_.col(2) * kSampledMargin;
    b.first.head<3>() = b.first.head<3>().cwiseMin(1.0);
    b.curvature = b.second.head<3>().norm();
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
      CurveBounds bounds;
      bounds.first = u.cwiseAbs();
      return bounds;
    }
    case SegmentKind::arc: return arc_bounds(path, i);
    default: return sampled_bounds(path, i);
  }
}

}  // namespace toolpace
