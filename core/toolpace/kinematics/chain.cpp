#include "toolpace/kinematics/chain.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace toolpace {
namespace {

using Eigen::Vector3d;
using Side = ChainSide;

Vector3d turned(const Vector3d& v, const Vector3d& axis, double angle) { return Eigen::AngleAxisd(angle, axis) * v; }

// Taylor coefficients: the k-th derivative divided by k!. Of n = 4 to the third order, of n = 1 the value alone.
template <std::size_t n>
using Series = std::array<double, n>;
template <std::size_t n>
using VectorSeries = std::array<Vector3d, n>;
constexpr std::array<double, 4> kFactorial = {1, 1, 2, 6};

template <std::size_t n>
struct Turn {
  Series<n> sine, cosine;
};

// s' = c·t', c' = −s·t', coefficient by coefficient.
template <std::size_t n>
Turn<n> turn_of(const Series<n>& angle) {
  const double s = std::sin(angle[0]), c = std::cos(angle[0]);
  if constexpr (n == 1) {
    return {{s}, {c}};
  } else {
    const double a = angle[1], b = 2 * angle[2], d = 3 * angle[3];
    const double s1 = a * c, c1 = -a * s;
    const double s2 = (a * c1 + b * c) / 2, c2 = -(a * s1 + b * s) / 2;
    return {{s, s1, s2, (a * c2 + b * c1 + d * c) / 3}, {c, c1, c2, -(a * s2 + b * s1 + d * s) / 3}};
  }
}

// Rodrigues' formula, the part along the axis apart: v = along + cos·across + sin·cross, by products of series.
template <std::size_t n>
void turn(VectorSeries<n>& v, const RotaryJoint& joint, const Turn<n>& t) {
  const Vector3d& u = joint.direction;
  v[0] -= joint.point;
  VectorSeries<n> across, cross;
  for (std::size_t k = 0; k < n; ++k) {
    const Vector3d along = u * u.dot(v[k]);
    across[k] = v[k] - along;
    cross[k] = u.cross(v[k]);
    v[k] = along;
    for (std::size_t i = 0; i <= k; ++i) v[k] += t.cosine[k - i] * across[i] + t.sine[k - i] * cross[i];
  }
  v[0] += joint.point;
}

// The same of a point that stands still.
template <std::size_t n>
void turn_fixed(VectorSeries<n>& v, const RotaryJoint& joint, const Turn<n>& t) {
  const Vector3d& u = joint.direction;
  const Vector3d arm = v[0] - joint.point, along = u * u.dot(arm), across = arm - along, cross = u.cross(arm);
  for (std::size_t k = 0; k < n; ++k) v[k] = t.cosine[k] * across + t.sine[k] * cross;
  v[0] += along;
  v[0] += joint.point;
}

template <std::size_t n>
Series<n> angle_of(const AxisVector* axes, std::size_t axis, double sign) {
  Series<n> s;
  for (std::size_t k = 0; k < n; ++k) s[k] = sign * axes[k][static_cast<Eigen::Index>(axis)] / kFactorial[k];
  return s;
}

// From the spindle's nose at all angles 0, where it is the origin, to the tip as the heads turn it.
// @param axes  n of them
template <std::size_t n>
VectorSeries<n> tool_shift(const Chain& chain, const AxisVector* axes) {
  const Vector3d length(0, 0, chain.tool_length);
  VectorSeries<n> v;
  v.fill(Vector3d::Zero());
  v[0] = -length;
  bool moves = false;
  // Outermost first: it carries the point, and is itself carried by those before it.
  for (auto joint = chain.joints.rbegin(); joint != chain.joints.rend(); ++joint) {
    if (joint->side != Side::head) continue;
    (moves ? turn<n> : turn_fixed<n>)(v, *joint, turn_of<n>(angle_of<n>(axes, joint->axis, 1)));
    moves = true;
  }
  v[0] += length;
  return v;
}

// The linear axes where the tip is told so.
template <std::size_t n>
VectorSeries<n> linear_axes(const Chain& chain, VectorSeries<n> tip, const AxisVector* rotary) {
  for (auto joint = chain.joints.rbegin(); joint != chain.joints.rend(); ++joint) {
    if (joint->side == Side::table) turn<n>(tip, *joint, turn_of<n>(angle_of<n>(rotary, joint->axis, 1)));
  }
  const VectorSeries<n> shift = tool_shift<n>(chain, rotary);
  for (std::size_t k = 0; k < n; ++k) tip[k] -= shift[k];
  return tip;
}

// The tip where the axes are so.
template <std::size_t n>
VectorSeries<n> tip_of(const Chain& chain, VectorSeries<n> linear, const AxisVector* axes) {
  const VectorSeries<n> shift = tool_shift<n>(chain, axes);
  for (std::size_t k = 0; k < n; ++k) linear[k] += shift[k];
  // Back through the tables, innermost first.
  for (const RotaryJoint& joint : chain.joints) {
    if (joint.side == Side::table) turn<n>(linear, joint, turn_of<n>(angle_of<n>(axes, joint.axis, -1)));
  }
  return linear;
}

}  // namespace

std::optional<Orientation> orientation_named(std::string_view name) {
  if (name == "axes") return Orientation::axes;
  if (name == "plane") return Orientation::plane;
  return std::nullopt;
}

bool Chain::swings_tool() const {
  return std::any_of(joints.begin(), joints.end(), [](const RotaryJoint& j) { return j.side == Side::head; });
}

ToolPose forward(const Chain& chain, const AxisVector& axes) {
  ToolPose pose{tip_of<1>(chain, {axes.head<3>()}, &axes)[0], Vector3d::UnitZ()};
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
  AxisVector axes = rotary;
  axes.head<3>() = linear_axes<1>(chain, {tip}, &rotary)[0];
  return axes;
}

AxisVector told_about(const Chain& to, const Chain& from, const AxisVector& place) {
  if (to == from) return place;
  AxisVector told = from.is_identity() ? place : axes_at(from, place.head<3>(), place);
  if (!to.is_identity()) told.head<3>() = forward(to, told).tip;
  return told;
}

Derivatives<AxisVector> axes_along(const Chain& chain, const Derivatives<Vector3d>& tip,
                                   const Derivatives<AxisVector>& rotary) {
  VectorSeries<4> series;
  for (std::size_t k = 0; k < series.size(); ++k) series[k] = tip[k] / kFactorial[k];
  const VectorSeries<4> linear = linear_axes<4>(chain, series, rotary.data());
  Derivatives<AxisVector> axes = rotary;
  for (std::size_t k = 0; k < axes.size(); ++k) axes[k].head<3>() = linear[k] * kFactorial[k];
  return axes;
}

Derivatives<Vector3d> tip_along(const Chain& chain, const Derivatives<AxisVector>& axes) {
  VectorSeries<4> series;
  for (std::size_t k = 0; k < series.size(); ++k) series[k] = axes[k].head<3>() / kFactorial[k];
  const VectorSeries<4> moved = tip_of<4>(chain, series, axes.data());
  Derivatives<Vector3d> tip;
  for (std::size_t k = 0; k < tip.size(); ++k) tip[k] = moved[k] * kFactorial[k];
  return tip;
}

}  // namespace toolpace
