#pragma once
/// Cutter radius compensation (G40 G41 G42 G41.1 G42.1): the tool runs beside the contour.
///
/// Outside corners get an arc about the corner; inside corners are cut at the intersection of the two offset elements,
/// for which the row before is shortened. The entry move ends beside the end of its programmed line.

#include "toolpace/nc/context.h"
#include "toolpace/nc/motion/arcs.h"

namespace toolpace::nc {

/// Runs G40 … G42.1 of a block.
bool set_compensation(Context& context, const Block& block);

/// Appends a straight move to `end` (contour, work coordinates), offset by the tool radius.
bool compensate_line(Context& context, MoveKind kind, const Position& end, const Feedrate& feed);

/// Appends an arc of the contour, offset by the tool radius.
bool compensate_arc(Context& context, const PlaneArc& contour, const Position& end, const Feedrate& feed);

}  // namespace toolpace::nc
