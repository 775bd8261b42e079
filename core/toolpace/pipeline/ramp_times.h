#pragma once
/// Do the least durations of ramps fit the blocks of a program?

#include <optional>

#include "toolpace/pipeline/job.h"

namespace toolpace {

/// Five-phase-time gives each ramp a least duration, and so a least length: half the speeds' sum times it. Blocks that are shorter
/// keep the speed that they are entered with, low as it may be. A longer Tacc or Tdec is the harder problem.
/// @return warning "ramp-times" where the plan takes more than half as long again as it would without least durations
Result<std::optional<Diagnostic>> check_ramp_times(const Outcome& outcome, const Monitor& monitor = {});

}  // namespace toolpace
