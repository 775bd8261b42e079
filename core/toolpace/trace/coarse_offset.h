#pragma once
/// Where a trace fits best beside what was commanded, by correlation.

#include <optional>

#include "toolpace/trace/commanded_rows.h"
#include "toolpace/trace/trace.h"

namespace toolpace::detail {

struct CoarseOffset {
  double offset;       ///< [s] time of the setpoints at the trace's first row
  double step;         ///< [s] what it was found to
  double correlation;  ///< of speeds, where both overlap
  bool is_ambiguous;
};

/// @param measured  columns of the trace, beside those of the setpoints
/// @return nothing where none of these axes moves
std::optional<CoarseOffset> coarse_offset(const CommandedRows& commanded, const Trace& trace,
                                          const std::array<std::vector<double>, kAxisCount>& measured,
                                          const std::array<bool, kAxisCount>& axes);

}  // namespace toolpace::detail
