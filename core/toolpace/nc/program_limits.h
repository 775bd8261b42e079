#pragma once
/// What programs tell controllers of speeds and accelerations that they may use, and whether the operator may change them.

#include "toolpace/nc/context.h"
#include "toolpace/nc/text/scanner.h"
#include "toolpace/nc/text/words.h"

namespace toolpace::nc {

/// M48 … M53: whether overrides of feed and rapid count. Those of the spindle, and adaptive feed, do not concern a plan.
void set_overrides(Context& context, const Block& block);

/// M201 (acceleration of each axis), M203 (its speed), M204 (acceleration along the path) and M205 (corners), as Marlin has
/// them: mm/s² and mm/s.
void set_program_limits(Context& context, const Block& block);

/// G187 P and G5.1 Q1 R: 0 … 1, see MotionCeiling::accuracy.
void set_accuracy(Context& context, double accuracy);

/// SET_VELOCITY_LIMIT of Klipper. @return whether the line is one
bool run_velocity_limit(Context& context, Scanner text);

}  // namespace toolpace::nc
