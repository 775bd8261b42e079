#pragma once
/// A planned program as JSON, with the keys of `plan --json`.

#include <nlohmann/json.hpp>

#include "toolpace/pipeline/job.h"
#include "toolpace/sample/axis_peaks.h"

namespace toolpace::cli {

/// A number, or null where it is not finite.
nlohmann::ordered_json number(double value);

/// Everything that the plan itself knows; the keys that need setpoints are added by the caller.
nlohmann::ordered_json outcome_json(const Outcome& outcome);

/// {"X": {"max_speed_mm_s": …}, …} of the axes that moved.
nlohmann::ordered_json axes_json(const AxisPeakMeter& meter);

/// {"line", "column", "code", "message"} each.
nlohmann::ordered_json diagnostics_json(const Diagnostics& diagnostics);

}  // namespace toolpace::cli
