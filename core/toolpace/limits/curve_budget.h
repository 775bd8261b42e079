#pragma once
/// How turning and changing speed share the limits of the axes on a curve.

#include "toolpace/limits/curve_bounds.h"
#include "toolpace/limits/machine.h"
#include "toolpace/limits/ramp_limits.h"

namespace toolpace {

/// What changes of speed may use on a curve that is run no faster than some cap, along the path.
struct CurveShare {
  double acceleration;  ///< [mm/s²] > 0
  double jerk;          ///< [mm/s³] > 0
};

/// What a ramp may do at the cap of its block.
enum class AtCap : std::uint8_t {
  rests,   ///< its acceleration has come to zero there, as that of ramps inside one block
  changes  ///< any acceleration
};

/// All motions along a segment that keep every axis inside its limits anywhere on it, as far as one inequality for each order
/// tells. With the direction and the normal at right angles, an axis' acceleration on a circle has the amplitude
/// √(a² + κ²v⁴) and its jerk √((j ∓ κ²v³)² + (3κva)²); in general, with v, a, j along the path,
///   (a/acceleration)² + (v²/square)² ≤ 1   or   |a| ≤ level − slope·v²,
///   √(((|j| + bend·v³)/jerk)² + (v·a/turning)²) ≤ 1 − v³/cube.
/// The second form is the better one where axes lie along the path and across it, as on short curves; then the parts of the
/// jerk may be apart as well: each of the two under the root is no more than the right side.
struct CurveBudget {
  double speed = kUnlimited;         ///< [mm/s] from the axes' top speeds
  double acceleration = kUnlimited;  ///< [mm/s²] where nothing turns
  double square = kUnlimited;        ///< [mm²/s²] where the speed is constant
  double level = kUnlimited;         ///< [mm/s²]
  double slope = 0;                  ///< [1/mm]
  double jerk = kUnlimited;          ///< [mm/s³] where nothing turns
  double turning = kUnlimited;       ///< [mm²/s³]
  double bend = 0;                   ///< [1/mm²]
  double cube = kUnlimited;          ///< [mm³/s³]
  bool is_apart = false;

  bool bends() const { return square < kUnlimited || turning < kUnlimited || cube < kUnlimited || bend > 0; }

  /// [mm/s] at which turning leaves next to nothing.
  double top_speed() const;

  /// Constant limits for changes of speed under a cap ≤ top_speed(). Where they rest at the cap, an acceleration a is met at
  /// speeds up to cap − a²/2j only: that much the speed still rises (has fallen) while jerk j takes a away. Then all of the
  /// normal part that the cap could ask for is not there yet. Accuracy 1 %, from below.
  CurveShare at(double cap, AtCap at_cap) const;
};

/// Limits along the path, and no more than a share.
Dynamics within(const Dynamics& along, const CurveShare& share);

/// @param axes  limits of the axes (curve_axes.h)
CurveBudget curve_budget(const CurveBounds& bounds, const std::array<AxisLimits, kAxisCount>& axes);

}  // namespace toolpace
