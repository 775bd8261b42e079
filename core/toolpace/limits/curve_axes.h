#pragma once
/// What limits of the path mean to an axis.

#include "toolpace/limits/machine.h"

namespace toolpace {

/// Each axis' limits where a path turns. The rule, in one place: limits along the path (--am, --jm) hold for every linear axis
/// as well, whether it has larger ones of its own or none; a rotary axis without one of its own takes the path's, a degree as
/// a millimetre. On lines nothing changes by that, for there no axis is faster than the path; on curves it bounds what turning
/// and changing speed take together. (Larger limits for slowing down, --dm and --jd, are of the path alone.)
/// @param keeps_jerk  whether the law bounds jerk; otherwise no axis' jerk counts
std::array<AxisLimits, kAxisCount> curve_axes(const Machine& machine, bool keeps_jerk);

}  // namespace toolpace
