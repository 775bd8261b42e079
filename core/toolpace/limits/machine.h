#pragma once
/// A machine and the defaults of its jobs, as its TOML file describes them.

#include <array>
#include <limits>
#include <string>

#include "toolpace/base/axes.h"
#include "toolpace/limits/servo_axis.h"

namespace toolpace {

inline constexpr double kUnlimited = std::numeric_limits<double>::infinity();

struct AxisLimits {
  double speed = kUnlimited;         ///< [mm/s, rad/s]
  double acceleration = kUnlimited;  ///< [mm/s², rad/s²]
  double jerk = kUnlimited;          ///< [mm/s³, rad/s³]
  double travel_min = -kUnlimited;   ///< [mm, rad]
  double travel_max = kUnlimited;    ///< [mm, rad]
  double steps_per_unit = 0.0;       ///< [1/mm, 1/rad]; 0 = no stepper
};

/// Limits along the path.
struct PathLimits {
  double speed = kUnlimited;              ///< [mm/s]
  double acceleration = kUnlimited;       ///< [mm/s²]
  double deceleration = kUnlimited;       ///< [mm/s²]
  double jerk = kUnlimited;               ///< [mm/s³]
  double jerk_deceleration = kUnlimited;  ///< [mm/s³] while slowing down
  /// [mm/s²] where a program asks for all the accuracy that it can (MotionCeiling::accuracy); speeding up and slowing down
  double fine_acceleration = kUnlimited;
};

struct Machine {
  std::string name;
  double period = 0.001;     ///< interpolation period [s]
  double tool_change = 0.0;  ///< [s]
  PathLimits path;
  std::array<AxisLimits, kAxisCount> axes;
  std::array<ServoAxis, kAxisCount> servo;  ///< how the drives follow; does not change the plan
};

}  // namespace toolpace
