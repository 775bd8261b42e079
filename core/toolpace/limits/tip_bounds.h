#pragma once
/// What the axes do while the tool's tip runs along a segment.

#include "toolpace/limits/curve_bounds.h"

namespace toolpace {

/// Bounds of the axes' derivatives by the path's length. Where the rotary axes rest, lines are exact. On other lines, by Taylor's
/// formula from the middle with a bound of the fourth derivative: never too small, and too large by about half the angle [rad] that
/// the rotary axes turn by; cut_for_axes() keeps that small. On other segments by samples, as curve_bounds() has them for
/// splines. There is no right angle between what the axes do along and across the path: together is 0, which is none.
/// @pre path.chain_of(segment)
CurveBounds tip_bounds(const Path& path, std::size_t segment);

/// Whether the farther one of the joints from the tool turns on a segment in whose middle the tool points nearly along it (within
/// 10 degrees of the pole): there a small change of the tool's direction takes a large turn, and linear axes that go with it.
/// @pre path.chain_of(segment)
bool is_near_pole(const Path& path, std::size_t segment);

}  // namespace toolpace
