#pragma once
/// What a plan comes to: times by kind of motion and by the limit that binds, peaks.

#include "toolpace/pipeline/job.h"

namespace toolpace {

/// @param outcome  planned, with its restraints
/// @return all but the bound, and what the corner rules count
Summary summarise(const Outcome& outcome);

}  // namespace toolpace
