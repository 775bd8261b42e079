#pragma once
/// A planned program as JSON, with the keys of `plan --json`.

#include "json.h"

#include "toolpace/pipeline/job.h"
#include "toolpace/sample/axis_peaks.h"

namespace toolpace::cli {

/// Everything that the plan itself knows; the keys that need setpoints are added by the caller.
Json outcome_json(const Outcome& outcome);

/// {"X": {"max_speed_mm_s": …}, …} of the axes that moved.
Json axes_json(const AxisPeakMeter& meter);

/// {"line", "column", "code", "message"} each.
Json diagnostics_json(const Diagnostics& diagnostics);

}  // namespace toolpace::cli
