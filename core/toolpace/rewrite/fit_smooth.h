#pragma once
/// A run as fewer blocks that pass into each other without corners.

#include "toolpace/rewrite/fit_run.h"

namespace toolpace::detail::rewrite {

/// Like fit_run(), but with ends of blocks that go on in the direction that they arrive in, seen in the plane of the arcs: biarcs
/// between directions of the curve, and single lines and arcs where those keep to them. Where neither gains anything, as in noise
/// or between corners, blocks are as fit_run() has them.
///
/// Biarcs take about half as many blocks again as single arcs.
///
/// @param plain  what fit_run() makes of the curve
/// @param monitor  where it is cancelled, spans stop short of the run's end
std::vector<Span> fit_smooth(const Curve& curve, const FitRules& rules, int plane, const std::vector<Span>& plain,
                             const Monitor& monitor = {});

}  // namespace toolpace::detail::rewrite
