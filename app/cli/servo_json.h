#pragma once
/// The "servo" object of plan --json and simulate --json.

#include "json.h"

#include "toolpace/limits/machine.h"
#include "toolpace/servo/servo_simulation.h"

namespace toolpace::cli {

/// What the simulation found, and "drives": what it took each axis' drive to be, under the keys of [servo.X].
Json servo_json(const ServoSummary& summary, const Machine& machine);

/// {frequency_hz, damping, share}
Json mode_json(const AxisMode& mode);

}  // namespace toolpace::cli
