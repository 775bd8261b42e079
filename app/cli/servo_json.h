#pragma once
/// The "servo" object of plan --json and simulate --json.

#include <nlohmann/json.hpp>

#include "toolpace/limits/machine.h"
#include "toolpace/servo/servo_simulation.h"

namespace toolpace::cli {

/// What the simulation found, and "drives": what it took each axis' drive to be, under the keys of [servo.X].
nlohmann::ordered_json servo_json(const ServoSummary& summary, const Machine& machine);

}  // namespace toolpace::cli
