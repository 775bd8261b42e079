#include "toolpace/kinematics/chain.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace toolpace {
namespace {

using Eigen::Vector3d;
using Side = ChainSide;

Vector3d turned(const Vector3d& v, const Vector3d& axis, double angle) { return Eigen::AngleAxisd(angle, axis) * v; }

// Taylor coefficients to the third order: the k-th derivative divided by k!.
using Series = std::array<double, 4>;
using VectorSeries = std::array<Vector3d, 4>;
constexpr std::array<double, 4> kFactorial = {1, 1, 2, 6};

VectorSeries product(const Series& a, const VectorSeries& b) {
  VectorSeries c;
  for (std::size_t k = 0; k < c.size(); ++k) {
    c[k].setZero();
    for (std::size_t i = 0; i <= k; ++i) c[k] += a[i] * b[k - i];
  }
  return c;
}

struct Turn {
  Series sine, cosine;
};

// s' = c·t', c' = −s·t', coefficient by coefficient.
Turn turn_of(const Series& angle) {
  Turn t{{std::sin(angle[0])}, {std::cos(angle[0])}};
  for (std::size_t k = 1; k < angle.size(); ++k) {
    for (std::size_t i = 1; i <= k; ++i) {
      const double weight = static_cast<double>(i) / static_cast<double>(k) * angle[i];
      t.sine[k] += weight * t.cosine[k - i];
      t.cosine[k] -= weight * t.sine[k - i];
    }
  }
  return t;
}

// Rodrigues' formula, the part along the axis apart.
VectorSeries turned(const VectorSeries& v, const RotaryJoint& joint, const Turn& turn) {
  VectorSeries along, across, cross;
  for (std::size_t k = 0; k < v.size(); ++k) {
    const Vector3d arm = k == 0 ? Vector3d(v[0] - joint.point) : v[k];
    along[k] = joint.direction * joint.direction.dot(arm);
    across[k] = arm - along[k];
    cross[k] = joint.direction.cross(arm);
  }
  const VectorSeries a = product(turn.cosine, across), b = product(turn.sine, cross);
  VectorSeries result;
  for (std::size_t k = 0; k < v.size(); ++k) result[k] = along[k] + a[k] + b[k];
  result[0] += joint.point;
  return result;
}

Series angle_of(const Derivatives<AxisVector>& axes, std::size_t axis, double sign) {
  Series s;
  for (std::size_t k = 0; k < s.size(); ++k) s[k] = sign * axes[k][static_cast<Eigen::Index>(axis)] / kFactorial[k];
  return s;
}

VectorSeries series_of(const Derivatives<Vector3d>& d) {
  VectorSeries s;
  for (std::size_t k = 0; k < s.size(); ++k) s[k] = d[k] / kFactorial[k];
  return s;
}

// Outermost first: it carries the point, and is itself carried by those before it.
VectorSeries carried(const Chain& chain, Side side, VectorSeries v, const Derivatives<AxisVector>& axes) {
  for (auto joint = chain.joints.rbegin(); joint != chain.joints.rend(); ++joint) {
    if (joint->side == side) v = turned(v, *joint, turn_of(angle_of(axes, joint->axis, 1)));
  }
  return v;
}

// From the spindle's nose at all angles 0, where it is the origin, to the tip as the heads turn it.
VectorSeries tool_shift(const Chain& chain, const Derivatives<AxisVector>& axes) {
  const Vector3d length(0, 0, chain.tool_length);
  VectorSeries v = carried(chain, Side::head, {-length, Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()}, axes);
  v[0] += length;
  return v;
}

Derivatives<AxisVector> at_rest(const AxisVector& axes) {
  return {axes, AxisVector::Zero(), AxisVector::Zero(), AxisVector::Zero()};
}

}  // namespace

bool Chain::swings_tool() const {
  return std::any_of(joints.begin(), joints.end(), [](const RotaryJoint& j) { return j.side == Side::head; });
}

ToolPose forward(const Chain& chain, const AxisVector& axes) {
  ToolPose pose{tip_along(chain, at_rest(axes))[0], Vector3d::UnitZ()};
  const auto angle = [&](const RotaryJoint& j) { return axes[static_cast<Eigen::Index>(j.axis)]; };
  for (auto j = chain.joints.rbegin(); j != chain.joints.rend(); ++j) {
    if (j->side == Side::head) pose.tool = turned(pose.tool, j->direction, angle(*j));
  }
  for (const RotaryJoint& j : chain.joints) {
    if (j.side == Side::table) pose.tool = turned(pose.tool, j.direction, -angle(j));
  }
  return pose;
}

AxisVector axes_at(const Chain& chain, const Vector3d& tip, const AxisVector& rotary) {
  return axes_along(chain, {tip, Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()}, at_rest(rotary))[0];
}

AxisVector told_about(const Chain& to, const Chain& from, const AxisVector& place) {
  if (to == from) return place;
  AxisVector told = from.is_identity() ? place : axes_at(from, place.head<3>(), place);
  if (!to.is_identity()) told.head<3>() = forward(to, told).tip;
  return told;
}

Derivatives<AxisVector> axes_along(const Chain& chain, const Derivatives<Vector3d>& tip,
                                   const Derivatives<AxisVector>& rotary) {
  const VectorSeries in_machine = carried(chain, Side::table, series_of(tip), rotary);
  const VectorSeries shift = tool_shift(chain, rotary);
  Derivatives<AxisVector> axes = rotary;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    axes[k].head<3>() = (in_machine[k] - shift[k]) * kFactorial[k];
  }
  return axes;
}

Derivatives<Vector3d> tip_along(const Chain& chain, const Derivatives<AxisVector>& axes) {
  const VectorSeries shift = tool_shift(chain, axes);
  VectorSeries v;
  for (std::size_t k = 0; k < v.size(); ++k) v[k] = axes[k].head<3>() / kFactorial[k] + shift[k];
  // Back through the tables, innermost first.
  for (const RotaryJoint& joint : chain.joints) {
    if (joint.side == Side::table) v = turned(v, joint, turn_of(angle_of(axes, joint.axis, -1)));
  }
  Derivatives<Vector3d> tip;
  for (std::size_t k = 0; k < tip.size(); ++k) tip[k] = v[k] * kFactorial[k];
  return tip;
}

}  // namespace toolpace
