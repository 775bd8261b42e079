#pragma once
/// Running a plan through the drives of its machine.

#include <functional>

#include "toolpace/pipeline/job.h"
#include "toolpace/servo/servo_simulation.h"

namespace toolpace {

/// Rows that have been simulated and measured: the first `rows` of both.
using FollowedRows = std::function<Result<void>(const Setpoints& commanded, const ServoTrace& trace, std::size_t rows)>;

/// Samples the plan and simulates the machine's drives, in bounded memory.
///
/// @param take  gets the rows in order, if given; an error of it ends the simulation
/// @return Errors: of AxisServo::create (usage), of `take`; cancelled
Result<ServoSummary> follow(const Outcome& outcome, const FollowedRows& take = {}, const Monitor& monitor = {});

}  // namespace toolpace
