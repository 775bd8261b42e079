#pragma once
/// The flags of the commands that lay a trace beside what was commanded.

#include <optional>
#include <string>

#include "job_flags.h"
#include "json.h"
#include "reading_flags.h"
#include "toolpace/trace/align.h"

namespace toolpace::cli {

/// What was commanded, what was measured, and the machine and job that flags tell.
struct TracePair {
  CommandedRows commanded;
  Trace trace;
  Setup setup;
};

struct TraceFlags {
  ReadingFlags reading;  ///< of a program; `program` is the first argument, be it one or a setpoint file
  JobFlags job;
  std::string trace, columns;
  std::optional<double> trace_period_ms;

  /// Adds the two arguments and the flags for them.
  void add_to(Command& command, Need arguments = Need::required);
  /// --trace-period-ms, checked [s]. Usage errors.
  Result<std::optional<double>> step() const;

  /// Reads both; a program is planned. Prints warnings to stderr.
  tl::expected<TracePair, Failure> read() const;
};

/// [{name, taken_for, unit}, …]
Json columns_json(const Trace& trace);
/// {offset_s, offset_error_s, drift_ppm, correlation, by, ambiguous}
Json alignment_json(const Alignment& alignment);
/// One line each.
void print_alignment(const Trace& trace, const Alignment& alignment);
/// To stderr: a place that is not the only one.
void warn_of_alignment(const Trace& trace, const Alignment& alignment);

}  // namespace toolpace::cli
