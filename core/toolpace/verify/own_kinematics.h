#pragma once
/// Where the axes have the tool, and what the axes must do: verification's own, by rotation matrices, so that a slip in kinematics/
/// does not prove itself.

#include "toolpace/path/path.h"

namespace toolpace {

/// Tip and direction of the tool in the workpiece.
struct SeenTool {
  Eigen::Vector3d tip;   ///< [mm]
  Eigen::Vector3d tool;  ///< of length 1, from the tip to the spindle
};
SeenTool seen_tool(const Chain& chain, const AxisVector& axes);

/// The axes for a tip [mm] beside rotary axes [rad].
AxisVector axes_for(const Chain& chain, const AxisVector& place);

/// What the axes do where tip and rotary axes have this frame, by differences: good to a few ten-thousandths.
Frame axes_frame(const Chain& chain, const Frame& place);

}  // namespace toolpace
