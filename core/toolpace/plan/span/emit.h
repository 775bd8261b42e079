#pragma once
/// Phases of a hull.

#include <vector>

#include "toolpace/plan/phase_writer.h"
#include "toolpace/plan/span/hull.h"
#include "toolpace/plan/span/kernel.h"
#include "toolpace/plan/span/mixed_hull.h"

namespace toolpace::detail {

/// Writes the motion along the hull: each kernel from the acceleration at which it is met to that at which it is left,
/// then the bridge. Every kernel is an anchor for position and speed, so that rounding does not add up.
void emit_hull(const std::vector<Kernel>& kernels, const SpanLimits& limits, const std::vector<HullEntry>& hull,
               PhaseWriter& out);

/// The same where each bridge has limits of its own.
void emit_hull(const std::vector<Kernel>& kernels, const MixedHull& hull, PhaseWriter& out);

/// A turn's kernel has its bottom beyond the node; the node itself, and its rest, are exact.
inline void begin_at_rest(std::vector<Phase>& phases) { phases.front().distance = phases.front().speed = 0.0; }

}  // namespace toolpace::detail
