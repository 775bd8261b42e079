#pragma once
/// A whole trace, checked.

#include "toolpace/trace/trace_file.h"

namespace toolpace {

inline constexpr std::size_t kFewestTraceRows = 32;

struct Trace {
  TraceRows rows;
  std::vector<TraceColumn> columns;
  std::size_t first_line = 1;  ///< of the file, that holds row 0
  std::string name;
  double step = 0;  ///< [s] usual time from row to row

  std::size_t size() const { return rows.time.size(); }
  /// Of any axis.
  bool has_commanded() const;
};

/// Reads a trace as a whole: 8 bytes a row for the time and for each column that means something.
/// Errors: of TraceFile; input, with the line: trace-short, trace-time (times that do not rise), trace-gap (a step of more
/// than ten usual ones).
Result<Trace> read_trace(const std::filesystem::path& file, const TraceOptions& options, const Monitor& monitor = {});

}  // namespace toolpace
