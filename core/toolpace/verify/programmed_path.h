#pragma once
/// What setpoints are compared with.

#include <optional>
#include <vector>

#include "toolpace/nc/moves.h"
#include "toolpace/path/path.h"

namespace toolpace {

/// The program that the setpoints are said to run.
struct ProgrammedPath {
  const Path& path;  ///< as programmed, corners not smoothed
  const Moves& moves;
  std::optional<double> tolerance = {};  ///< [mm] judged; none = the deviation is measured only
  /// [mm] of each segment, where some are to be followed more closely than `tolerance`; empty = all alike
  std::vector<double> segment_tolerance = {};
};

}  // namespace toolpace
