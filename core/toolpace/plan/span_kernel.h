#pragma once
/// Speed caps as the hull of ramps sees them.

#include <cstdint>
#include <limits>

#include "toolpace/limits/ramp_limits.h"

namespace toolpace::detail {

/// What a bridge may use: the smallest limits of the blocks under it.
struct SpanLimits {
  double up = std::numeric_limits<double>::infinity();         ///< acceleration [mm/s²]
  double up_jerk = std::numeric_limits<double>::infinity();    ///< [mm/s³]
  double down = std::numeric_limits<double>::infinity();       ///< deceleration [mm/s²]
  double down_jerk = std::numeric_limits<double>::infinity();  ///< [mm/s³]

  static SpanLimits of(const Dynamics& d) { return {d.up.acceleration, d.up.jerk, d.down.acceleration, d.down.jerk}; }

  void include(const SpanLimits& o) {
    up = o.up < up ? o.up : up;
    up_jerk = o.up_jerk < up_jerk ? o.up_jerk : up_jerk;
    down = o.down < down ? o.down : down;
    down_jerk = o.down_jerk < down_jerk ? o.down_jerk : down_jerk;
  }
};

/// The largest jerk-limited curve under a cap: it rises on both sides of a bottom (of zero acceleration) with full
/// jerk. A node's bottom is a point, near the node; a plateau's is a stretch at the top speed of its blocks.
struct Kernel {
  double left, right;                   ///< where the bottom begins and ends; equal for points [mm]
  double bottom;                        ///< speed there [mm/s]
  double up_jerk, down_jerk;            ///< on the rising and on the falling side [mm/s³]
  double position, cap;                 ///< the node's own place and cap; plateaus: left, bottom [mm, mm/s]
  double tilt = 0.0;                    ///< acceleration with which the node is to be crossed [mm/s²]
  std::uint32_t first_node, last_node;  ///< nodes that it lies between; equal for points
  SpanLimits own;                       ///< of a plateau's blocks
  SpanLimits before;                    ///< of the blocks between the kernel before this one and this one

  bool is_plateau() const { return first_node != last_node; }
};

/// Sets the tilt, and with it the bottom: v = cap and a = tilt at the node.
inline void set_tilt(Kernel& k, double tilt) {
  const double jerk = tilt > 0 ? k.up_jerk : k.down_jerk;
  const double time = tilt / jerk;
  k.tilt = tilt;
  k.bottom = k.cap - tilt * time / 2;
  k.left = k.right = k.position - time * (k.cap - tilt * time / 3);
}

}  // namespace toolpace::detail
