#pragma once
/// Cycle time over look-ahead depth.

#include <optional>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/pipeline/job.h"

namespace toolpace {

struct SweepPoint {
  std::optional<std::size_t> lookahead;  ///< blocks; none = all
  double cycle_time;                     ///< [s]
};

struct LookaheadSweep {
  std::vector<SweepPoint> points;  ///< depth rising, "all" last
  std::size_t knee;                ///< index of the least depth within half a percent of the time at "all"
};

/// Plans the job at depths 1, 2, 3, 4, 6, 8, 12, 16, … up to the number of blocks, and at all: each by the law itself, as what
/// is timed anew (Job::refined) has no depth. A motion through the tube takes the same time at any.
Result<LookaheadSweep> sweep_lookahead(const Job& job, const Monitor& monitor = {});

}  // namespace toolpace
