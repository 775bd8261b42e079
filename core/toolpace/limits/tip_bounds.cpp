#include "toolpace/limits/tip_bounds.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "toolpace/limits/peak_search.h"
#include "toolpace/path/axis_curve.h"
#include "toolpace/path/curve_sampler.h"

namespace toolpace {
namespace {

constexpr int kStretches = 2;           // of splines and blends
constexpr double kArcStretch = 0.8;     // [rad]
constexpr double kNearPole = 0.173648;  // sin 10°

using Magnitudes = std::array<double, 5>;  // of a vector and its first four derivatives

/// What a turn at a rate w makes of them (Leibniz, by norms).
Magnitudes turned(const Magnitudes& m, double w) {
  const double w2 = w * w;
  return {m[0], w * m[0] + m[1], w2 * m[0] + 2 * w * m[1] + m[2], w2 * w * m[0] + 3 * w2 * m[1] + 3 * w * m[2] + m[3],
          w2 * w2 * m[0] + 4 * w2 * w * m[1] + 6 * w2 * m[2] + 4 * w * m[3] + m[4]};
}

/// Of a point that the joints of one side carry, from the joint next to it outwards.
double fourth_derivative(const Chain& chain, ChainSide side, Eigen::Vector3d point, Magnitudes m,
                         const AxisVector& rates) {
  for (auto joint = chain.joints.rbegin(); joint != chain.joints.rend(); ++joint) {
    if (joint->side != side) continue;
    m[0] += (point - joint->point).norm();  // from here on the arm; so far what it may differ by
    const double arm = m[0];
    m = turned(m, std::fabs(rates[static_cast<Eigen::Index>(joint->axis)]));
    m[0] = arm;
    point = joint->point;
  }
  return m[4];
}

/// A line on which the rotary axes turn at constant rates.
CurveBounds line_bounds(const Chain& chain, const Path& path, std::size_t i) {
  const double half = path.length[i] / 2;
  const Frame tip = frame_at(path, i, half), axes = through(chain, tip);
  const Magnitudes of_tip{half * tip.first.head<3>().norm(), tip.first.head<3>().norm(), 0, 0, 0};
  const double fourth = fourth_derivative(chain, ChainSide::table, tip.point.head<3>(), of_tip, tip.first) +
                        fourth_derivative(chain, ChainSide::head, {0, 0, -chain.tool_length}, Magnitudes{}, tip.first);
  CurveBounds b;
  b.together.setZero();
  const AxisVector first = axes.first.cwiseAbs(), second = axes.second.cwiseAbs(), third = axes.third.cwiseAbs();
  AxisVector rest = AxisVector::Zero();
  rest.head<3>().setConstant(fourth);
  b.third = third + half * rest;
  b.second = second + half * (third + half / 2 * rest);
  b.first = first + half * (second + half / 2 * (third + half / 3 * rest));
  return b;
}

/// Derivatives by length at shares of a segment.
class AxisSampler {
 public:
  AxisSampler(const Path& path, std::size_t segment)
      : curve_(path), segment_(segment), chain_(*path.chain_of(segment)) {
    if (path.kind[segment] >= SegmentKind::spline) tip_.emplace(path, segment);
  }

  template <int rows>
  ParameterDerivatives at_share(double share) const {
    const Frame f = frame_at_share(share);
    return {f.first, f.second, f.third};
  }

 private:
  /// Of the own parameter, where there is one: it does not matter how long the way there is.
  Frame frame_at_share(double share) const {
    const Path& path = curve_.path();
    if (path.kind[segment_] < SegmentKind::spline) return curve_.frame_at(segment_, share * path.length[segment_]);
    const ParameterDerivatives d = tip_->at_share(share);
    return through(chain_, {point_at_share(path, segment_, share), d.first, d.second, d.third});
  }

  AxisCurve curve_;
  std::size_t segment_;
  const Chain& chain_;
  std::optional<CurveSampler> tip_;
};

CurveBounds sampled_bounds(const Path& path, std::size_t i) {
  const AxisSampler curve(path, i);
  int stretches = kStretches;
  if (path.kind[i] == SegmentKind::arc) {
    stretches = static_cast<int>(std::clamp(std::ceil(path.arcs[path.detail[i]].sweep / kArcStretch), 1.0, 1e4));
  }
  CurveBounds b = PeakSearch<kAxisCount, AxisSampler>(curve, path.length[i])
                      .run(curve.at_share<kAxisCount>(0.0), curve.at_share<kAxisCount>(1.0), stretches);
  b.together.setZero();
  return b;
}

}  // namespace

CurveBounds tip_bounds(const Path& path, std::size_t i) {
  const AxisCurve curve(path);
  if (curve.is_straight(i)) {
    CurveBounds b;
    b.first = curve.start_direction(i).cwiseAbs();
    return b;
  }
  return is_even_line(path, i) ? line_bounds(*path.chain_of(i), path, i) : sampled_bounds(path, i);
}

bool is_near_pole(const Path& path, std::size_t i) {
  const Chain& chain = *path.chain_of(i);
  if (chain.joints.size() < 2) return false;
  // As the workpiece sees it, the farther one is the table's last joint, or of two heads the first.
  const auto is_table = [](const RotaryJoint& j) { return j.side == ChainSide::table; };
  const bool has_table = std::any_of(chain.joints.begin(), chain.joints.end(), is_table);
  const RotaryJoint& farther =
      has_table ? *std::find_if(chain.joints.rbegin(), chain.joints.rend(), is_table) : chain.joints.front();
  const Frame tip = frame_at(path, i, path.length[i] / 2);
  if (tip.first[static_cast<Eigen::Index>(farther.axis)] == 0) return false;
  return forward(chain, tip.point).tool.cross(farther.direction).norm() < kNearPole;
}

}  // namespace toolpace
