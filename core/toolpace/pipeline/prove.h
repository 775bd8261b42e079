#pragma once
/// Judging a plan's setpoint file by what the job asked for.

#include <filesystem>

#include "toolpace/pipeline/job.h"
#include "toolpace/verify/verify.h"

namespace toolpace {

/// The machine as its setpoints are judged: a law that does not bound jerk is not judged by jerk.
Machine judged_machine(const Machine& machine, const PlanOptions& options);

/// What setpoint files say of the plan, for those who judge them without it.
SetpointOrigin origin_of(const Outcome& outcome);

/// How far a job may round the corners of a row of Moves [mm]: its own tolerance, or that of G64 P in the program; 0 under
/// G61 and G61.1, and where the job's corner rule stays on the path.
double corner_tolerance(const Moves& moves, std::uint32_t row, const CornerOptions& corner);

/// How far from the programmed path a job's setpoints may be anywhere [mm]: what rounding leaves for the corner rules that stay on
/// the path, the largest corner_tolerance() of the program for those that smooth corners.
double judged_tolerance(const Moves& moves, const CornerOptions& corner);

/// Reads the file back and judges it by machine, options and program; the setpoints themselves where the program changes between axes
/// and the tool's tip, and the file does not tell the lines. Errors: of verify().
Result<VerifyReport> prove(const std::filesystem::path& setpoints, const Outcome& outcome, const Monitor& monitor = {});

/// The same for the setpoints themselves, without a file.
Result<VerifyReport> prove(const Outcome& outcome, const Monitor& monitor = {});

/// The checks that they do not pass, which is known sooner than by how much. Errors: of verify().
Result<std::vector<Check>> broken_checks(const Outcome& outcome, const Monitor& monitor = {});

/// Whether there are none.
bool is_proven(const Outcome& outcome, const Monitor& monitor = {});

}  // namespace toolpace
