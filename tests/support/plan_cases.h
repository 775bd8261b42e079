#pragma once
/// SpeedLimits for tests of planning: published cases and random chains.

#include <cstdint>
#include <optional>
#include <vector>

#include "polylines.h"
#include "toolpace/limits/speed_limits.h"

namespace toolpace::test {

/// What a polyline is planned with.
struct PolylineRules {
  Dynamics dynamics;
  std::optional<double> corner_step = {};         ///< [mm/s] V·|u_{i+1} − u_i| ≤ step
  std::optional<double> servo_acceleration = {};  ///< [mm/s²] the source's servo and angle rules, with `period`
  double period = 0.001;                          ///< [s]
  double axis_acceleration = 0;                   ///< [mm/s²] 0 = path limits only
  double axis_jerk = 0;                           ///< [mm/s³]
  double axis_speed = 0;                          ///< [mm/s]
};

Dynamics symmetric(double acceleration, double jerk, double time = 0);

/// Blocks on a line.
SpeedLimits line_of(const std::vector<double>& length, const std::vector<double>& feed, const Dynamics& dynamics);

/// The 20 blocks of Ning et al. 2014, laid on a line (examples/nc/blocks20.ngc).
SpeedLimits ning_blocks(const Dynamics& dynamics);

/// A polyline as speed limits. `repeat` strings copies of it together, each starting where the last one ended.
SpeedLimits limits_of(const Polyline& polyline, const PolylineRules& rules, std::size_t repeat = 1);

/// Seeded random chain: micro and long blocks, collinear stretches, mixed feeds, stops, low node caps.
SpeedLimits random_chain(std::uint64_t seed, std::size_t blocks, bool mixed_dynamics = false);

/// The same chain as one that goes back at some of its nodes.
SpeedLimits with_reversals(SpeedLimits limits, std::uint64_t seed);

/// Seeded random chain over many orders of magnitude: lengths, feeds, caps and limits in units drawn at random.
SpeedLimits wild_chain(std::uint64_t seed);

}  // namespace toolpace::test
