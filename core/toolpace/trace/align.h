#pragma once
/// A trace laid beside what was commanded: when it began, how its clock runs.

#include <array>
#include <vector>

#include "toolpace/trace/commanded_rows.h"
#include "toolpace/trace/trace.h"

namespace toolpace {

inline constexpr double kLeastCorrelation = 0.9;  ///< of speeds; below it the trace is of another program
inline constexpr double kMostUnlike = 0.25;       ///< of the way: RMS of the following error, above it it is one, too

struct Alignment {
  double offset = 0;      ///< [s] time of the setpoints at the trace's first row
  double first_time = 0;  ///< [s] what the trace's own clock says there
  double drift = 0;  ///< how much the setpoints' clock gains on the trace's, 1e-6 = 1 µs a second; 0 where none shows
  double offset_error = 0;  ///< [s] standard error of the offset in the trace's middle
  double drift_error = 0;
  double correlation = 0;  ///< of speeds, −1 … 1
  bool by_commanded =
      false;  ///< by the commanded positions that the trace recorded itself: lags are lags of the drives.
              ///< Else their common part is in the offset
  bool is_ambiguous = false;                  ///< another place fits as well: a part of a program that repeats itself
  std::array<bool, kAxisCount> axis = {};     ///< that both have
  std::array<double, kAxisCount> shift = {};  ///< [mm, rad] the trace's zero, as what it measured tells: see align()

  /// Time of the setpoints [s] at a time of the trace's clock.
  double at(double trace_time) const { return offset + (1 + drift) * (trace_time - first_time); }
  /// What the trace's clock shows less what the setpoints' does, at the trace's first row [s].
  double clock_offset() const { return first_time - offset; }
};

/// Finds the offset by the correlation of speeds of all axes that move, coarsely by Fourier transforms and then to a small
/// part of a sample by least squares of the positions, and the drift by the offsets of sixteen parts of the trace. The zero of
/// an axis (its constant offset) is free.
///
/// Errors (input): trace-axes where no axis that moves is in both; trace-other-program where the correlation is below
/// kLeastCorrelation, or positions differ by more than kMostUnlike of their own deviation; trace-unit where an axis moves by a factor more or less than commanded (mm read as inches, a reversed
/// axis).
Result<Alignment> align(const CommandedRows& commanded, const Trace& trace, const Monitor& monitor = {});

}  // namespace toolpace
