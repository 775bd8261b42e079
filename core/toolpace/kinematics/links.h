#pragma once
/// A chain as the workpiece sees it.

#include <vector>

#include "toolpace/kinematics/chain.h"

namespace toolpace::detail {

/// A joint as the tool is turned by it, seen from the workpiece.
struct Link {
  std::size_t axis;
  Eigen::Vector3d direction;
  double sign;  ///< of the axis' angle
};

/// From the tool to the workpiece.
inline std::vector<Link> links_of(const Chain& chain) {
  std::vector<Link> links;
  for (auto j = chain.joints.rbegin(); j != chain.joints.rend(); ++j) {
    if (j->side == ChainSide::head) links.push_back({j->axis, j->direction, 1});
  }
  for (const RotaryJoint& j : chain.joints) {
    if (j.side == ChainSide::table) links.push_back({j.axis, j.direction, -1});
  }
  return links;
}

}  // namespace toolpace::detail
