#pragma once
/// Plans whose ramps end inside their blocks, as in the sources.

#include <cstddef>
#include <optional>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/law/law_table.h"
#include "toolpace/limits/speed_limits.h"
#include "toolpace/plan/motion_plan.h"

namespace toolpace::detail {

/// Node caps that also respect both neighbours' feeds; the ends rest [mm/s].
std::vector<double> joined_caps(const SpeedLimits& limits);

/// Cycle time of plan_block_ramps, without the plan [s].
/// @param blocks  look-ahead, ≥ 1
/// @param margin  blocks at either end whose time is left out
double time_block_ramps(const SpeedLimits& limits, LawKind law, std::size_t blocks, std::size_t margin = 0);

/// Speeds of that plan [mm/s], and its time [s].
struct BlockSpeeds {
  std::vector<double> node;
  std::vector<double> peak;  ///< of each block
  double time;
};
BlockSpeeds block_ramp_speeds(const SpeedLimits& limits, LawKind law, std::size_t blocks);

/// @param blocks  look-ahead, ≥ 1
/// @return no phases when cancelled
MotionPlan plan_block_ramps(const SpeedLimits& limits, LawKind law, std::size_t blocks, const Monitor& monitor);

}  // namespace toolpace::detail
