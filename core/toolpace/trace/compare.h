#pragma once
/// Commanded and measured, side by side: lag, following error, contour error, by axis and by NC line.

#include "toolpace/trace/align.h"

namespace toolpace {

struct AxisComparison {
  bool is_measured = false;
  double lag = 0;        ///< [s] by which the axis follows its command, by least squares
  double max_error = 0;  ///< largest |following error| [mm, rad]
  double rms_error = 0;
  double worst_time = 0;  ///< [s] of the setpoints
  std::uint32_t worst_line = 0;
  double shift = 0;  ///< [mm, rad] zero of the trace less that of the setpoints, taken off the errors; 0 where it
                     ///< is no more than errors are
};

struct LineComparison {
  std::uint32_t line = 0;
  double begin = 0;  ///< [s] of the setpoints, when it was first run
  std::size_t rows = 0;
  double max_contour = 0, rms_contour = 0;      ///< [mm; a degree counts as 1 mm]
  double max_following = 0, rms_following = 0;  ///< distance from the commanded point [mm]
};

/// How one row of the trace lies beside its command.
struct ComparedRow {
  std::size_t row;            ///< of the trace
  double time;                ///< [s] of the setpoints
  double following, contour;  ///< [mm]
};

struct Comparison {
  Alignment alignment;
  std::size_t rows = 0;     ///< of the trace that fall into the program
  std::size_t outside = 0;  ///< before it began and after it ended
  std::array<AxisComparison, kAxisCount> axis;
  double max_contour = 0, rms_contour = 0, max_following = 0, rms_following = 0;  ///< [mm]
  double worst_time = 0;                                                          ///< [s] of the contour error
  std::uint32_t worst_line = 0;
  std::vector<LineComparison> lines;         ///< in the order of their numbers; empty where setpoints have none
  std::vector<std::string> unmeasured = {};  ///< axes that move and are not in the trace: "Z"
};

/// The contour error is the distance to the path through the setpoints of the measured axes (see ContourMeter).
///
/// @param rows  if given, gets every row that was compared
/// Errors: of align(); input: trace-saturated where an axis stands at its end while it is commanded to move on, trace-short
/// where less than kFewestTraceRows fall into the program; cancelled.
Result<Comparison> compare(const CommandedRows& commanded, const Trace& trace, std::vector<ComparedRow>* rows = nullptr,
                           const Monitor& monitor = {});

/// Errors: trace-saturated, with its line.
Result<void> check_saturation(const CommandedRows& commanded, const Trace& trace, const Alignment& alignment);

}  // namespace toolpace
