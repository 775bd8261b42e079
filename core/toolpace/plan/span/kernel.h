#pragma once
/// Speed caps as the hull of ramps sees them.

#include <cstdint>

#include "toolpace/plan/span/exact_place.h"
#include "toolpace/plan/span/ramp.h"

namespace toolpace::detail {

/// What all bridges of a hull may use: speeding up and slowing down.
struct SpanLimits {
  SpanRamp up, down;
};

/// The largest jerk-limited curve under a cap: it rises on both sides of a bottom (of zero acceleration) with full
/// jerk. A node's bottom is a point, near the node; a plateau's is a stretch at the top speed of its blocks.
///
/// Where a plateau borders on faster blocks, the node there is a kernel of its own beside it. With a tilt it lets the motion
/// cross the border still slowing down, dip below the plateau's speed, and come back to it further on.
struct Kernel {
  ExactPlace left, right;               ///< where the bottom begins and ends; equal for points [mm]
  double bottom;                        ///< speed there [mm/s]
  ExactPlace position;                  ///< the node's own place; plateaus: left [mm]
  double cap;                           ///< the node's own cap; plateaus: bottom [mm/s]
  double tilt;                          ///< acceleration with which the node is to be crossed [mm/s²]
  ExactPlace end;                       ///< of the whole plateau; points: position [mm]
  std::uint32_t first_node, last_node;  ///< nodes that it lies between; equal for points

  bool is_plateau() const { return first_node != last_node; }
};

/// Sets the tilt, and with it the bottom: v = cap and a = tilt at the node.
inline void set_tilt(Kernel& k, double tilt, const SpanLimits& limits) {
  const double time = tilt * (tilt > 0 ? limits.up.slack : limits.down.slack);
  k.tilt = tilt;
  k.bottom = k.cap - tilt * time / 2;
  k.left = k.right = k.position - time * (k.cap - tilt * time / 3);
}

}  // namespace toolpace::detail
