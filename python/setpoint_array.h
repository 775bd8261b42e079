#pragma once
/// All setpoints of a plan in memory, as .npy files hold them.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "toolpace/pipeline/job.h"

namespace toolpace::python {

struct SetpointArray {
  std::vector<std::string> names;   ///< "t_s", "x_mm", …
  std::vector<double> values;       ///< row by row, names.size() each
  std::vector<std::int64_t> lines;  ///< NC line of each row
};

/// @param tip_of  as SetpointTable takes it
/// Errors: cancelled; those of SetpointTable::load.
Result<SetpointArray> setpoint_array(const Outcome& outcome, const std::optional<Chain>& tip_of,
                                     const Monitor& monitor);

}  // namespace toolpace::python
