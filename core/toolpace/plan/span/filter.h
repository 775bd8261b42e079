#pragma once
/// Which speed caps can matter: those that the acceleration-limited optimum touches.

#include <cstddef>
#include <vector>

#include "toolpace/limits/speed_limits.h"
#include "toolpace/plan/span/exact_place.h"
#include "toolpace/plan/span/kernel.h"

namespace toolpace::detail {

/// Relative: squares of speeds that are nearer touch.
inline constexpr double kTouch = 1e-12;

/// Squares of the node speeds of the acceleration-limited optimum [mm²/s²]. No motion within the same caps and
/// accelerations is faster anywhere.
/// @param cap  of the nodes, no higher than either neighbour's [mm/s]
/// @source the two-pass scan of time-optimal path following, Bobrow et al. 1985, in q = v²
std::vector<double> fastest_squares(const SpeedLimits& limits, const std::vector<double>& cap);

/// Nodes [first, last] of a chain that rests nowhere between, as arrays that share one index.
struct SpanChain {
  const SpeedLimits& limits;
  const std::vector<double>& cap;           ///< [mm/s]
  const std::vector<double>& square;        ///< of fastest_squares [mm²/s²]
  const std::vector<ExactPlace>& position;  ///< of these nodes, counted from the first [mm]
  std::size_t first, last;
};

/// Caps that can matter, in order: the start, nodes and plateaus that the optimum touches, the end. Tilts are 0.
void select_kernels(const SpanChain& chain, std::vector<Kernel>& kernels);

}  // namespace toolpace::detail
