#pragma once
/// The hull where ramp limits change from block to block: each bridge keeps the smallest limits under its own span.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "toolpace/limits/ramp_limits.h"
#include "toolpace/plan/span/filter.h"
#include "toolpace/plan/span/hull.h"
#include "toolpace/plan/span/kernel.h"

namespace toolpace::detail {

/// Ramp limits of a stretch of blocks.
struct SpanBounds {
  double up = 1e300, up_jerk = 1e300;      ///< [mm/s², mm/s³]
  double down = 1e300, down_jerk = 1e300;  ///< [mm/s², mm/s³]

  bool operator==(const SpanBounds&) const = default;

  void include(const SpanBounds& o) {
    up = std::min(up, o.up);
    up_jerk = std::min(up_jerk, o.up_jerk);
    down = std::min(down, o.down);
    down_jerk = std::min(down_jerk, o.down_jerk);
  }

  void include(const Dynamics& d) {
    include(SpanBounds{d.up.acceleration, d.up.jerk, d.down.acceleration, d.down.jerk});
  }

  SpanLimits limits() const { return {{up, up_jerk}, {down, down_jerk}}; }
};

inline SpanBounds smaller(SpanBounds a, const SpanBounds& b) {
  a.include(b);
  return a;
}

/// Parts plateaus where their limits change.
void part_by_limits(const SpanChain& chain, std::vector<Kernel>& kernels);

/// For each kernel the limits of the blocks between it and the one before it.
std::vector<SpanBounds> limits_before(const SpanChain& chain, const std::vector<Kernel>& kernels);

/// A hull and the limits of each of its bridges.
struct MixedHull {
  std::vector<HullEntry> entries;
  std::vector<SpanBounds> met;  ///< limits of the bridge that leads to the entry
};

/// The kernel with the bottom that its tilt gives it under some limits.
inline Kernel kernel_under(const Kernel& k, const SpanLimits& limits) {
  Kernel under = k;
  if (k.tilt != 0) set_tilt(under, k.tilt, limits);
  return under;
}

/// As build_hull(). A kernel that is met before its node and left behind it (at its cap, with the tilt) parts two bridges that
/// know nothing of each other. Where the motion meets it already speeding up beyond the tilt, or leaves it slowing down
/// already, both bridges lie on one of its sides and share one set of limits, the smaller one of each: then everything is as
/// in the hull under one set of limits. Tilts that would put bottoms out of order are taken away.
/// @param kernels,before  of part_by_limits() and limits_before()
/// @return false where the start cannot be left fast enough, the end not be reached, or limits change so that most
///         bridges would have to be made again and again
bool build_mixed_hull(const SpeedLimits& limits, const std::vector<SpanBounds>& before, std::vector<Kernel>& kernels,
                      MixedHull& hull);

/// Time along the hull [s].
double hull_time(const std::vector<Kernel>& kernels, const MixedHull& hull);

}  // namespace toolpace::detail
