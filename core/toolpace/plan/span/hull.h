#pragma once
/// The plan as the lower hull of all speed caps: which of them are touched, and the bridges between these.

#include <cstdint>
#include <vector>

#include "toolpace/plan/span/bridge.h"
#include "toolpace/plan/span/kernel.h"

namespace toolpace::detail {

/// A touched cap and the bridge that leads to it. The first one is the start and has none: it is met with its own tilt.
struct HullEntry {
  Bridge bridge;
  std::uint32_t kernel;
};

/// Whether a kernel is left no earlier than it is met.
inline bool is_in_order(const Kernel& k, const Bridge& met, const Bridge& left) {
  if (left.kind == BridgeKind::near_is_idle) return false;
  if (k.is_plateau() && !(met.meet_at == left.leave_at)) return met.meet_at < left.leave_at;
  return met.meet <= left.leave;
}

/// Goes through the kernels once; each is bridged to from the last touched one. A kernel that cannot be reached is
/// skipped; a touched one that would have to be left before it is met is dropped again. Linear: at most two bridges a
/// kernel, amortised.
/// @param kernels  sorted by `left`
/// @return false where the start cannot be left, or the end not be met, as their tilts say, which never happens where these
///         are 0
bool build_hull(const std::vector<Kernel>& kernels, const SpanLimits& limits, std::vector<HullEntry>& hull);

/// Brings a hull up to date after some kernels were changed: goes anew only from each changed kernel on until the new hull
/// has joined the old one again.
/// @param changed  ascending
/// @return as build_hull()
bool rebuild_hull(const std::vector<Kernel>& kernels, const SpanLimits& limits,
                  const std::vector<std::uint32_t>& changed, std::vector<HullEntry>& hull);

/// Time along the hull [s].
double hull_time(const std::vector<Kernel>& kernels, const SpanLimits& limits, const std::vector<HullEntry>& hull);

}  // namespace toolpace::detail
