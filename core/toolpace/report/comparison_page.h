#pragma once
/// Two plans of one program side by side, as one self-contained HTML page.

#include <string>
#include <vector>

#include "toolpace/pipeline/job.h"

namespace toolpace {

/// A setting in which they differ, as people read it.
struct ChangedSetting {
  std::string title, before, after;
};

/// Cycle time, contour error, vibration and peaks of both, what was changed, where the time goes, and the speed of both over one time.
///
/// @return HTML 5, UTF-8, without any reference to other files. Errors: of follow() and vibration().
Result<std::string> comparison_page(const Outcome& before, const Outcome& after,
                                    const std::vector<ChangedSetting>& changed, const Monitor& monitor = {});

}  // namespace toolpace
