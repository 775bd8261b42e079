#pragma once
/// How far the axes of a plan swing over time, ready to be drawn.

#include <array>
#include <memory>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/pipeline/job.h"

namespace toolpace::ui {

/// Exact at its instants (servo/vibration.h); axes without a mode are empty.
struct VibrationTrace {
  std::vector<double> time;                                      ///< [s]
  std::array<std::vector<float>, kAxisCount> displacement = {};  ///< [mm, rad]
};

/// Each interpolation period, or less often where that would be more than kMostInstants. Null where no axis has a mode, and when
/// cancelled. Call it on a worker.
inline constexpr double kMostInstants = 2e6;
std::shared_ptr<const VibrationTrace> make_vibration_trace(const Outcome& outcome, const Monitor& monitor = {});

}  // namespace toolpace::ui
