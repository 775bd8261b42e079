#pragma once
/// One pass over the setpoints of a plan: measured, and written where a file is wanted.

#include "toolpace/io/setpoint_writer.h"
#include "toolpace/pipeline/job.h"
#include "toolpace/sample/axis_peaks.h"

namespace toolpace::cli {

/// What it finds out.
struct SetpointPass {
  std::size_t rows = 0;
  AxisPeakMeter peaks;
  double chord_error = 0.0;  ///< [mm]
  double shaping = 0.0;      ///< [mm] Sampler::largest_offset()
};

/// Samples the plan once. Without a writer and without measuring nothing but the number of rows is found out, as a slow program
/// has millions.
///
/// @param writer  may be null
Result<SetpointPass> pass_over_setpoints(const Outcome& outcome, SetpointWriter* writer, bool measures,
                                         const Monitor& monitor);

}  // namespace toolpace::cli
