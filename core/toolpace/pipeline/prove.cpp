#include "toolpace/pipeline/prove.h"

#include <algorithm>

#include "toolpace/law/law_table.h"
#include "toolpace/path/build_path.h"

namespace toolpace {
namespace {

constexpr double kExact = 1e-6;  // [mm]

}  // namespace

Machine judged_machine(const Machine& machine, const PlanOptions& options) {
  Machine judged = machine;
  if (law_row(options.law).bounds_jerk) return judged;
  judged.path.jerk = judged.path.jerk_deceleration = kUnlimited;
  for (auto& axis : judged.axes) axis.jerk = kUnlimited;
  return judged;
}

double judged_tolerance(const Moves& moves, const CornerOptions& corner) {
  const bool smooths = !corner.step && (corner.rule == CornerRule::blend || corner.rule == CornerRule::smooth);
  double tolerance = smooths ? corner.tolerance : 0.0;
  for (const MoveMode& mode : moves.modes) {
    if (mode.control == PathControl::blend) tolerance = std::max(tolerance, mode.tolerance + mode.naive_tolerance);
  }
  return tolerance + kExact;
}

Result<VerifyReport> prove(const std::filesystem::path& setpoints, const Outcome& outcome, const Monitor& monitor) {
  const Job& job = *outcome.job;
  const Moves& moves = job.program->moves;
  const auto path = build_path(moves, job.machine.tool_change);  // as programmed: the outcome's may be smoothed
  if (!path) return tl::unexpected(path.error());
  auto file = open_setpoint_file(setpoints);
  if (!file) return tl::unexpected(file.error());
  const ProgrammedPath program{*path, moves, judged_tolerance(moves, job.options.corner)};
  return verify(**file, judged_machine(job.machine, job.options), &program, monitor);
}

}  // namespace toolpace
