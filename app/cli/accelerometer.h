#pragma once
/// What `identify --accelerometer` makes of a recording, and tells of it.

#include <array>
#include <optional>
#include <string>

#include "json.h"
#include "toolpace/servo/find_modes.h"
#include "toolpace/servo/servo_simulation.h"
#include "toolpace/trace/acceleration.h"

namespace toolpace::cli {

struct ShakenAxis {
  FoundModes found;
  std::vector<AxisMode> kept;  ///< for the machine file: rounded, without the one that is the axis' resonance already
};

/// Nothing for axes that the file has no column of, or in which no mode shows.
struct ShakenAxes {
  std::array<std::optional<ShakenAxis>, 3> axis;
  Diagnostics warnings;
};

/// Errors: of find_modes(); input: accelerometer-no-peak where no axis has a mode.
Result<ShakenAxes> find_shaken_axes(const AccelerationRecord& record, const ServoMachine& servo);

Json accelerometer_json(const AccelerationRecord& record, const ShakenAxes& shaken, const std::string& output);
void print_accelerometer(const AccelerationRecord& record, const ShakenAxes& shaken);

}  // namespace toolpace::cli
