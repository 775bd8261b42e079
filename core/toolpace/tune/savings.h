#pragma once
/// "Raise X by 10 % -> saves Y s", found by planning again.

#include <string>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/pipeline/job.h"

namespace toolpace {

struct Saving {
  std::string parameter;  ///< key as in machine files, "axes.X.max_jerk_mm_s3"; "feed_override_percent" for the feed
  double value;           ///< as the file has it, in the key's unit
  double raised;          ///< the value that was tried
  double saved;           ///< [s] of cycle time; negative where raising costs time
};

/// Raises each bounded limit of the machine, the corner tolerance in use and the feed override, one at a time, by
/// `factor`, plans again, and sorts by what is saved. (Times of ramps are shortened by the factor.)
Result<std::vector<Saving>> find_savings(const Job& job, double cycle_time, double factor = 1.1,
                                         const Monitor& monitor = {});

}  // namespace toolpace
