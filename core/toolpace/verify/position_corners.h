#pragma once
/// Corners seen in the positions alone, for files without a program.

#include "toolpace/verify/corner_limit.h"
#include "toolpace/verify/corner_log.h"
#include "toolpace/verify/row_stream.h"

namespace toolpace {

/// What is known of corners and rows.
struct CornerSight {
  const CornerLimit& limit;
  double period;  ///< [s]
  double noise;   ///< [mm] rounding of a position
};

/// Steps of the speed of each axis where a straight run of at least two chords meets another one in another direction,
/// within the row interval `local` (between rows local−1 and local) or at row local: at the speed of the run, up to what the
/// corner's limit lets pass. No step where the rows show anything else, such as a curve or a row out of line.
CornerEvent corner_between_straights(const RowStream& stream, std::size_t local, const CornerSight& sight);

bool is_none(const CornerEvent& event);

/// The same where a curve meets a line or another curve, at a corner as corner_between_curves() sees it.
CornerEvent corner_beside_curve(const RowStream& stream, std::size_t local, const CornerSight& sight);

/// How much longer than its chord the way of the row interval `local` is, where that cuts the corner between two straight
/// runs [mm; deg where only rotary axes move]; 0 where the rows show anything else.
double detour_between_straights(const RowStream& stream, std::size_t local, double noise);

/// The same at a corner as corner_between_curves() sees it, but for what the curves themselves bulge.
double detour_beside_curve(const RowStream& stream, std::size_t local, double noise);

}  // namespace toolpace
