#pragma once
/// Path + machine -> SpeedLimits: how fast each block and each node may be run.

#include "toolpace/base/monitor.h"
#include "toolpace/limits/corner_rule.h"
#include "toolpace/limits/machine.h"
#include "toolpace/limits/speed_limits.h"
#include "toolpace/path/commanded.h"

namespace toolpace {

/// What of a job decides its speed limits, besides what is commanded.
struct LimitOptions {
  CornerOptions corner;
  double t_acc = 0.0;           ///< [s] handed on to laws that keep a constant time
  double t_dec = 0.0;           ///< [s]
  double rapid_override = 1.0;  ///< of the axes' top speeds, where rapids go round corner curves
  bool keeps_jerk = true;       ///< whether the law does; without, curves are not held to the axes' jerk
};

/// The machine's part in what is commanded: its top speeds, without overrides and whatever the program lowers.
CommandOptions command_options(const Machine& machine);

/// Speed caps and ramp limits of every block and node.
///
/// Block cap: what is commanded, and each axis' top speed (V·|u| ≤ Vmax, Ning et al. 2014,
/// section 2.1). On curves at most the speed at which turning takes all that the axes have (curve_axes.h says what that is,
/// curve_budget.h how it is shared); a lower cap, which leaves more, is settle_curves()' choice. Ramp limits: the path's, and
/// what each axis leaves along the block's direction. Node cap: the corner rule of the job, or of the program's G61, G61.1; never above
/// either neighbour's cap.
///   servo     each axis' speed step V·|Δu| ≤ a·Ts with the axis' own a (the path's where it has none), and
///             2V·sin(α/2) ≤ a·Ts with the path's a (the slowest turning axis' where it has none); Ning et al.,
///             section 2.1
///   junction  V² = a·δ·cos(α/2)/(1 − cos(α/2)), δ the junction deviation, α the deflection
/// A block that nothing bounds is a usage error ("no-speed-limit").
Result<SpeedLimits> limit_speed(const Path& path, const Commands& commands, const Machine& machine,
                                const LimitOptions& options, const Monitor& monitor = {});

/// Largest speed that the corner rule allows between two directions, ignoring the blocks' own caps; infinite for none.
/// @param before, after  direction by path length, per axis
double corner_speed(const CornerOptions& corner, const AxisVector& before, const AxisVector& after,
                    const Machine& machine);

/// The same of what the program asks for: no axis' speed may step by more (Marlin M205 X Y Z), and V² = a·δ·cos(α/2)/(1 − cos(α/2))
/// with δ the junction deviation (M205 J), or such that V is the given speed at a right angle (Klipper's
/// SQUARE_CORNER_VELOCITY).
double corner_speed(const MotionCeiling& ceiling, const AxisVector& before, const AxisVector& after,
                    const Machine& machine);

}  // namespace toolpace
