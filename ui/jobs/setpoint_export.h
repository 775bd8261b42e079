#pragma once
/// Writes what a machine runs: a plan's setpoints, or its step pulses, as a file.

#include <QString>

#include "toolpace/pipeline/job.h"

namespace toolpace::ui {

struct ExportOptions {
  bool axis_derivatives = false;  ///< add v, a, j of each axis (not in halstream)
  bool decimal_comma = false;     ///< .semicolon.csv
  double timer_hz = 1e6;          ///< of the pulses' timer, .pulses.csv
};

/// The name chooses the format: .csv, .npy, .npz, .halstream, .semicolon.csv, or .pulses.csv for the step pulses of every
/// axis that has steps_per_mm. The file appears whole or not at all. Errors: usage (unknown format, no steppers, timer),
/// io, cancelled.
/// @return rows written
Result<std::size_t> write_setpoints(const Outcome& outcome, const QString& file, const ExportOptions& options = {},
                                    const Monitor& monitor = {});

}  // namespace toolpace::ui
