#include "toolpace/verify/own_kinematics.h"

#include <algorithm>
#include <cmath>

namespace toolpace {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kStep = 1e-4;  // [rad] that the rotary axes turn by in a difference

/// A rigid motion: p ↦ turn·p + shift.
struct Placement {
  Matrix3d turn = Matrix3d::Identity();
  Vector3d shift = Vector3d::Zero();
};

/// About a line through a point: 1 + sin·K + (1 − cos)·K², K the cross product with the direction.
Placement turn_about(const RotaryJoint& joint, double angle) {
  Matrix3d k;
  const Vector3d& d = joint.direction;
  k << 0, -d.z(), d.y(), d.z(), 0, -d.x(), -d.y(), d.x(), 0;
  Placement p;
  p.turn += std::sin(angle) * k + (1 - std::cos(angle)) * (k * k);
  p.shift = joint.point - p.turn * joint.point;
  return p;
}

Placement of_side(const Chain& chain, ChainSide side, const AxisVector& axes) {
  Placement all;
  for (const RotaryJoint& joint : chain.joints) {
    if (joint.side != side) continue;
    const Placement one = turn_about(joint, axes[static_cast<Eigen::Index>(joint.axis)]);
    all.shift += all.turn * one.shift;
    all.turn = (all.turn * one.turn).eval();
  }
  return all;
}

/// By how much heads move the tip away from where it is at angles of 0.
Vector3d swing(const Chain& chain, const Placement& head) {
  const Vector3d tool(0, 0, -chain.tool_length);
  return head.turn * tool + head.shift - tool;
}

}  // namespace

SeenTool seen_tool(const Chain& chain, const AxisVector& axes) {
  const Placement table = of_side(chain, ChainSide::table, axes), head = of_side(chain, ChainSide::head, axes);
  const Vector3d in_machine = axes.head<3>() + swing(chain, head);
  return {table.turn.transpose() * (in_machine - table.shift), table.turn.transpose() * head.turn.col(2)};
}

AxisVector axes_for(const Chain& chain, const AxisVector& place) {
  const Placement table = of_side(chain, ChainSide::table, place), head = of_side(chain, ChainSide::head, place);
  AxisVector axes = place;
  axes.head<3>() = table.turn * place.head<3>() + table.shift - swing(chain, head);
  return axes;
}

Frame axes_frame(const Chain& chain, const Frame& place) {
  const double rate = place.first.tail<3>().cwiseAbs().maxCoeff();
  const double bend = place.second.tail<3>().cwiseAbs().maxCoeff(), twist = place.third.tail<3>().cwiseAbs().maxCoeff();
  // Neither the turn nor its change may be large in a step, nor the step beside the tip's radius.
  const double h = std::min({1.0, 1 / std::max(place.second.head<3>().norm(), 1.0), kStep / std::max(rate, kStep),
                             std::sqrt(kStep / std::max(bend, kStep)), std::cbrt(kStep / std::max(twist, kStep))});
  // The third derivative of the tip would only stay in the difference that is meant for its first.
  AxisVector third = place.third;
  third.head<3>().setZero();
  const auto at = [&](double s) {
    return axes_for(chain, place.point + s * (place.first + s / 2 * (place.second + s / 3 * third)));
  };
  const AxisVector before = at(-h), here = at(0), behind = at(h);
  Frame axes = place;
  axes.point = here;
  axes.first.head<3>() = ((behind - before) / (2 * h)).head<3>();
  axes.second.head<3>() = ((behind - 2 * here + before) / (h * h)).head<3>();
  return axes;
}

}  // namespace toolpace
