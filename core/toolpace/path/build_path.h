#pragma once
/// Moves -> Path.

#include "toolpace/base/monitor.h"
#include "toolpace/nc/moves.h"
#include "toolpace/path/path.h"

namespace toolpace {

/// Builds the exact geometry of a program. Rows without length vanish; splines are cut into pieces (path/spline.h) that
/// share their row; dwells, tool changes, stops, probes and taps become pauses.
///
/// @param tool_change  [s] pause of each tool change
/// @return Error "cancelled", or "path-not-finite" for a coordinate that is not a finite number
Result<Path> build_path(const Moves& moves, double tool_change, const Monitor& monitor = {});

}  // namespace toolpace
