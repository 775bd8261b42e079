#pragma once
/// How the axes of a machine vibrate under a plan, shaped or not.

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"
#include "toolpace/plan/motion_plan.h"
#include "toolpace/sample/shaper.h"
#include "toolpace/servo/servo_simulation.h"

namespace toolpace {

/// What a stop leaves of one mode, share counted [mm, rad].
struct ModeVibration {
  AxisMode mode;
  double residual = 0;
};

/// Of an axis with modes: the displacement of its slide against its drive, which is taken to do what is commanded.
struct AxisVibration {
  std::vector<ModeVibration> modes;  ///< all of the axis (modes_of()), each with its own worst stop
  double peak = 0;                   ///< [mm, rad] largest displacement while it moves
  double peak_time = 0;              ///< [s]
  std::uint32_t peak_move = 0;       ///< row of Moves
  double residual =
      0;  ///< [mm, rad] largest amplitude that a stop leaves (AxisModes::amplitude()): pauses, stops on the way, the end
  double residual_time = 0;  ///< [s] of that stop
  std::uint32_t residual_move = 0;
};
using Vibration = std::array<std::optional<AxisVibration>, kAxisCount>;

/// Looks at displacements at times 0, step, 2·step, …, as exact as the rest, up to the end of the motion.
struct VibrationWatch {
  double step = 0;  ///< [s] > 0
  /// Row by row: of each axis [mm, rad], 0 where it has no mode.
  std::function<void(const AxisVector& displacement)> take = {};
};

/// Exact on lines and beside the path (rounding apart); on curves accelerations are interpolated over at most a quarter of a
/// radian, by polynomials of the fifth degree, to 1e-9 of them. Steps of speed at corners count.
///
/// @param watch      gets the displacements on the way, if given
/// @param node_time  [s] arrival at each node of the path
/// @param impulses   that shape the motion: times are then those of the shaped one, moves those of its first echo
/// @return nothing for axes without a mode. Errors: cancelled
Result<Vibration> vibration(const Path& path, const MotionPlan& plan, const std::vector<double>& node_time,
                            const ServoMachine& servo, const Impulses& impulses, const Monitor& monitor = {},
                            const VibrationWatch& watch = {});

/// The largest residual of any axis, in what people read its axis in [mm, deg]; nothing where no axis has a mode.
std::optional<double> largest_residual(const Vibration& vibration);

}  // namespace toolpace
