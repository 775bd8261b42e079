#pragma once
/// What a change of speed may use, along the path.

#include <limits>

namespace toolpace {

/// What one ramp may use. Infinite = unbounded.
struct RampLimits {
  double acceleration = std::numeric_limits<double>::infinity();  ///< [mm/s²], > 0
  double jerk = std::numeric_limits<double>::infinity();          ///< [mm/s³], > 0
  double time = 0.0;  ///< [s] Tacc or Tdec: the duration five-phase-time gives every ramp; 0 for other laws
  bool operator==(const RampLimits&) const = default;
};

/// Limits for speeding up and for slowing down.
struct Dynamics {
  RampLimits up, down;
  bool operator==(const Dynamics&) const = default;
};

}  // namespace toolpace
