#pragma once
/// The "servo" object of plan --json and simulate --json.

#include <nlohmann/json.hpp>

#include "toolpace/servo/servo_simulation.h"

namespace toolpace::cli {

nlohmann::ordered_json servo_json(const ServoSummary& summary);

}  // namespace toolpace::cli
