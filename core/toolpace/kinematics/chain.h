#pragma once
/// The rotary axes between workpiece and tool, and where the tool's tip is while they turn.
///
/// A chain has up to two rotary axes, each carrying the workpiece (table) or the spindle (head), with any direction and any
/// place. At all angles 0 the linear axes are the tip's workpiece coordinates and the tool points along −Z. With H and R for
/// what heads and tables turn, L the tool's length and x the linear axes:
///
///   tip = R⁻¹(x + H(0, 0, −L) + (0, 0, L)),   tool = R⁻¹·H·(0, 0, 1) as directions

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "toolpace/base/axes.h"

namespace toolpace {

enum class ChainSide : std::uint8_t { table, head };

/// How the tool's direction runs between the directions that two blocks tell.
enum class Orientation : std::uint8_t {
  axes,  ///< the rotary axes turn evenly
  plane  ///< the tool turns evenly in the plane of both directions: along a great circle
};

/// "axes" or "plane"; none of other names.
std::optional<Orientation> orientation_named(std::string_view name);

struct RotaryJoint {
  std::size_t axis;           ///< 3 … 5: A, B or C
  ChainSide side;             ///< what it carries: the workpiece or the spindle
  Eigen::Vector3d direction;  ///< of unit length; a positive angle turns what the joint carries about it, right-handed
  /// Of the joint at all angles 0 [mm]: of a table in machine coordinates, of a head from the spindle's nose.
  Eigen::Vector3d point;
  bool operator==(const RotaryJoint&) const = default;
};

/// Values of a chain, from the machine's base outwards: of two heads (or tables) the first one carries the second.
struct Chain {
  std::vector<RotaryJoint> joints;  ///< at most two, no axis twice
  double tool_length = 0.0;         ///< [mm] from the spindle's nose to the tip, ≥ 0
  Orientation orientation = Orientation::axes;

  bool is_identity() const { return joints.empty(); }
  /// Whether a joint carries the spindle: only then the tool's length matters.
  bool swings_tool() const;
  bool operator==(const Chain&) const = default;
};

/// [kinematics] of a machine: how its rotary axes carry workpiece and tool.
struct Kinematics {
  Chain chain;
  bool tells_tool_length = false;

  bool operator==(const Kinematics&) const = default;
};

/// Where the tool is, seen from the workpiece.
struct ToolPose {
  Eigen::Vector3d tip;   ///< [mm]
  Eigen::Vector3d tool;  ///< unit vector from the tip to the spindle
};

ToolPose forward(const Chain& chain, const AxisVector& axes);

/// The linear axes that put the tip at `tip` while the rotary ones stand at those of `rotary`, whose X Y Z are not read.
/// @return all axes [mm, rad]. Exact but for rounding, about 1e-15 of the largest coordinate.
AxisVector axes_at(const Chain& chain, const Eigen::Vector3d& tip, const AxisVector& rotary);

/// A place that is told about the tip of one chain, tip [mm] and rotary axes [rad], told about that of another one, while no axis
/// moves. About a chain without joints it is told by the axes themselves.
AxisVector told_about(const Chain& to, const Chain& from, const AxisVector& place);

/// A point and its first three derivatives by one parameter.
template <class Vector>
using Derivatives = std::array<Vector, 4>;

/// The axes and their derivatives where the tip and the rotary axes move as given: derivatives of a composition to the third
/// order, by products of Taylor series and so exact but for rounding.
/// @param rotary  the rotary axes; X Y Z are not read
Derivatives<AxisVector> axes_along(const Chain& chain, const Derivatives<Eigen::Vector3d>& tip,
                                   const Derivatives<AxisVector>& rotary);

/// The tip and its derivatives where the axes move as given.
Derivatives<Eigen::Vector3d> tip_along(const Chain& chain, const Derivatives<AxisVector>& axes);

}  // namespace toolpace
