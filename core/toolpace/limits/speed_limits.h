#pragma once
/// All that planning needs to know of a path: lengths, speed caps and ramp limits, as flat arrays.

#include <cstdint>
#include <vector>

#include "toolpace/base/cause.h"
#include "toolpace/limits/curve_budget.h"
#include "toolpace/limits/ramp_limits.h"

namespace toolpace {

/// What the path as a whole may use, and what sets it: the machine, or the program where that lowers it.
struct AlongPath {
  Dynamics dynamics;
  Cause own = Cause::acceleration;           ///< where nothing else bounds a block
  Cause of_axes = Cause::axis_acceleration;  ///< where axes do
};

struct SpeedLimits {
  // One entry a block.
  std::vector<double> length;       ///< [mm] > 0
  std::vector<double> block_cap;    ///< top speed inside the block [mm/s] > 0
  std::vector<std::uint32_t> ramp;  ///< index into dynamics
  std::vector<Cause> block_cause;   ///< what sets block_cap
  // One entry a node, size() + 1. Node 0 is the start.
  std::vector<double> node_cap;  ///< [mm/s] ≥ 0; 0 = the machine rests there; first and last are 0
  std::vector<Cause> node_cause;

  /// Nodes where the path goes back the way it came, from line to line and without a pause, rising. There an axis that slows
  /// down to rest and one that speeds up again accelerate the same way: rest need not be without acceleration. Slices may
  /// have them at their ends, where they rest all the same.
  std::vector<std::uint32_t> reversals;

  std::vector<Dynamics> dynamics;  ///< the different ramp limits (dynamics_table.h)
  /// What sets them, one entry each: acceleration (of the path), axis_acceleration or program_limit. Empty = acceleration
  /// everywhere.
  std::vector<Cause> dynamics_cause;

  // One entry a curve: cap and ramp limits of its block are a choice among all that its budget allows, at first the highest
  // cap and what that leaves (settle_curves() chooses better). Slices have none.
  std::vector<std::uint32_t> curved;  ///< blocks that turn, rising
  CurveBudgets budget;
  std::vector<std::uint16_t> ceiling;  ///< index into along
  std::vector<AlongPath> along;        ///< under each ceiling of the program
  /// Nodes beside curves, rising, where the corner rule allows no more than a speed [mm/s], whatever the caps of their blocks.
  struct Corner {
    std::uint32_t node;
    double speed;
  };
  std::vector<Corner> corners;

  std::size_t size() const { return length.size(); }
  const Dynamics& dynamics_of(std::size_t block) const { return dynamics[ramp[block]]; }
};

/// What sets dynamics that are no higher than those along the path.
Cause cause_of(const Dynamics& dynamics, const AlongPath& along);

/// Blocks begin … end − 1 as a chain of their own, from rest to rest. @pre begin < end ≤ all.size()
SpeedLimits slice(const SpeedLimits& all, std::size_t begin, std::size_t end);

}  // namespace toolpace
