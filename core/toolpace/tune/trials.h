#pragma once
/// One plan of many: made, run through the drives, and judged.

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/pipeline/job.h"
#include "toolpace/tune/pareto.h"

namespace toolpace {

struct Judged {
  Objectives objectives;
  bool is_bound = false;  ///< the drives were not followed to the end: the contour error is larger than this
};

/// The largest contour error that is still of interest beside what is known of a plan before it is followed: its time and vibration.
/// [mm]
using WorthFollowing = std::function<double(const Objectives& known)>;

/// Makes plans from several threads. What they share (a path, its limits) is taken over from one to another; results do not depend
/// on which.
class Trials {
 public:
  /// The outcome itself is dropped. Errors: of run() and follow().
  Result<Judged> run(std::shared_ptr<const Job> job, const WorthFollowing& worth, const Monitor& monitor);

 private:
  std::shared_ptr<const Outcome> nearest_to(const Job& job);
  void keep(Outcome outcome);

  std::mutex shared_;
  std::vector<std::shared_ptr<const Outcome>> kept_;  ///< the last one used in front
};

}  // namespace toolpace
