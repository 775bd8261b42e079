#pragma once
/// Long lines and arcs about the tool's tip, cut so that the axes do much the same all along a piece.

#include "toolpace/path/path.h"

namespace toolpace {

/// The same path, in which no line or arc about the tip turns the rotary axes by more than 8.6 degrees in all: what the axes do on
/// it changes little from end to end, so that one cap of speed suits it. A path that is told by its axes stays as it is.
///
/// Pieces keep the move that they come from. @post AxisCurve::is_cut() at the nodes that were added
Path cut_for_axes(Path path);

}  // namespace toolpace
