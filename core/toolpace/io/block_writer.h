#pragma once
/// Motion blocks as a table: what the interpreter understood, one row a block, in the columns of `toolpace blocks`.

#include <filesystem>
#include <string>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"
#include "toolpace/nc/reading.h"

namespace toolpace {

inline constexpr std::size_t kChordsPerControlPoint = 15;

/// Points on a spline row, first point left out: kChordsPerControlPoint chords a control point, equal steps of the
/// parameter, which are the chords that LinuxCNC cuts. They stand for the curve in the table alone; planning has the curve.
std::vector<AxisVector> spline_chords(const AxisVector& begin, const AxisVector& end, const SplineDetail& spline);

/// Writes the table; a refused program ends with a row of kind "error". "-" = standard output.
/// Units: mm, deg, mm/min (deg/min where only A, B, C move), s. Errors: io, cancelled.
Result<void> write_blocks(const std::filesystem::path& file, const Reading& reading, const Monitor& monitor = {});

}  // namespace toolpace
