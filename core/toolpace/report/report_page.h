#pragma once
/// A report on a plan as one self-contained HTML page with inline SVG.

#include <string>

#include "toolpace/pipeline/job.h"

namespace toolpace {

/// Program, machine, law, cycle time and where it goes, plots of speed, acceleration, jerk and contour error, the contour,
/// limits with margins, and what verification found. Samples, simulates and verifies the plan for it.
///
/// @return HTML 5, UTF-8, without any reference to other files. Errors: of follow(), prove() and lower_bound().
Result<std::string> report_page(const Outcome& outcome, const Monitor& monitor = {});

}  // namespace toolpace
