#pragma once
/// Path -> Path with rounded corners.

#include "toolpace/base/monitor.h"
#include "toolpace/nc/moves.h"
#include "toolpace/path/commanded.h"
#include "toolpace/path/path.h"

namespace toolpace {

struct BlendCount {
  std::size_t corners = 0;  ///< replaced by a curve
  std::size_t stops = 0;    ///< that turn back too sharply, or lie beside a segment of rotary axes alone
  std::size_t merged = 0;   ///< segments that became part of a longer one
  double deviation = 0;     ///< bound of the largest distance from the programmed path [mm, deg]
};

struct BlendedPath {
  Path path;
  BlendCount count;
};

/// True if any block of the program asks for blends by itself (G64 P).
bool asks_for_blends(const Moves& moves);

/// Rounds the corners of a path in continuous path mode: curvature is continuous, every point of either curve is within the
/// tolerance of the other, in order. Runs of nearly straight short segments of one feed become one (at most a third of the
/// tolerance). Neighbouring blends share a segment. Nodes with a pause, nodes of blocks under G61 or G61.1, and corners
/// above 111° (where a stop costs less) stay as they are. Linear time.
/// @return error cancelled
Result<BlendedPath> blend_path(const Path& path, const Moves& moves, const Rounding& options,
                               const Monitor& monitor = {});

}  // namespace toolpace
