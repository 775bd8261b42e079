#pragma once
/// A plan made faster where curves let the axes do more than caps by the block say.

#include "toolpace/base/monitor.h"
#include "toolpace/limits/machine.h"
#include "toolpace/limits/speed_limits.h"
#include "toolpace/path/commanded.h"
#include "toolpace/plan/for_each.h"
#include "toolpace/plan/motion_plan.h"

namespace toolpace {

/// Block caps and ramp limits of a curve share the axes' limits between turning and changing speed, once for all. Here each
/// stretch from rest to rest that has curves is timed anew under the axes' limits themselves: the same path, another speed.
/// Stretches with corners that are crossed with a speed step stay as they are, as does what would not become faster.
/// Linear time; stretches may be timed at the same time, with the same result.
/// @param plan   of these limits, without pauses
/// @return no phases when cancelled
MotionPlan retime(const Path& path, const Commands& commands, const Machine& machine, const SpeedLimits& limits,
                  const MotionPlan& plan, const ForEach& for_each = for_each_in_turn, const Monitor& monitor = {});

}  // namespace toolpace
