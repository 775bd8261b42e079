#pragma once
/// What a stretch with curves takes at least from rest to rest.

#include <cstddef>

#include "toolpace/pipeline/job.h"

namespace toolpace::detail {

/// Whether timing_bound() may say more of segments begin … end − 1 than caps and ramp limits do: there are curves, and no
/// corner is crossed with a step; the law keeps jerk.
bool has_timing_bound(const Outcome& outcome, std::size_t begin, std::size_t end);

/// Lower bound of the time on these segments from rest to rest, under the axes' limits (curve_axes.h) place by place [s]: the
/// dual of the fastest timing (timing_dual.h), with less than the error of its quadrature taken off.
/// @param known  what the stretch takes at least anyway; where a plan is hardly slower, the dual is not asked
double timing_bound(const Outcome& outcome, std::size_t begin, std::size_t end, double known);

}  // namespace toolpace::detail
