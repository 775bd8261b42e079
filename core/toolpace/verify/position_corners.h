#pragma once
/// Corners seen in the positions alone, for files without a program.

#include <functional>

#include "toolpace/verify/corner_log.h"
#include "toolpace/verify/row_stream.h"

namespace toolpace {

/// Steps of the speed of each axis where a straight run of at least two chords meets another one in another direction,
/// within the row interval `local` (between rows local−1 and local) or at row local. No step where the rows show
/// anything else, such as a curve or a row out of line.
///
/// @param period  [s]
/// @param noise   [mm] rounding of a position
CornerEvent corner_between_straights(const RowStream& stream, std::size_t local, double period, double noise);

}  // namespace toolpace
