#pragma once
/// "X ten per cent up -> saves Y s, adds Z µm": what each setting does alone, found by planning again.

#include <memory>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/pipeline/job.h"
#include "toolpace/tune/pareto.h"

namespace toolpace {

/// A job that differs from another in one setting.
struct SingleChange {
  std::shared_ptr<const Job> job;
  double saved = 0;          ///< [s] of cycle time; negative where it costs time
  double contour_added = 0;  ///< [mm] to the largest contour error through the drives; negative where that falls
};

struct SingleChanges {
  Objectives present;                 ///< of the job as it is
  std::vector<SingleChange> changes;  ///< what saves most first
};

/// Tries each bounded limit of the machine, the times of ramps, the corner's size and the feed override, one at a time, up and down by
/// `factor`, the look-ahead at half, twice and all blocks, and each other law, corner rule and way of ramps; plans again and runs the
/// plan through the drives. What cannot be planned is left out, and so is what is out of its range.
/// Errors: of run() and follow() for the job as it is; cancelled.
Result<SingleChanges> try_single_changes(const std::shared_ptr<const Job>& job, double factor = 1.1,
                                         const Monitor& monitor = {});

}  // namespace toolpace
