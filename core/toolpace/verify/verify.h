#pragma once
/// An independent proof of a setpoint file: nothing of it comes from planning.

#include <optional>

#include "toolpace/base/monitor.h"
#include "toolpace/limits/corner_rule.h"
#include "toolpace/limits/machine.h"
#include "toolpace/verify/programmed_path.h"
#include "toolpace/verify/report.h"
#include "toolpace/verify/setpoint_file.h"

namespace toolpace {

struct VerifyOptions {
  /// The job's corner rule, up to which corners are exempt; none = that of the file, where it says one.
  std::optional<CornerOptions> corner = {};
  /// Whether to find out within which distance a program is followed; otherwise only whether within its tolerance, which
  /// takes fewer passes.
  bool measures = true;
  Monitor monitor = {};
  /// Without a program: the rows are about the tip of this chain, and so are speed and acceleration along the path.
  std::optional<Chain> tip_of = {};
};

/// Checks the file against the machine and, if given, the program. Reads the file once, or several times where it is
/// not on the path to 1e-6 mm. Bounded memory, whatever the file's length.
///
/// Where the corner rule is not known, a corner of up to a right angle is exempt at any speed, and one that turns back farther
/// only by what the servo rule, or a junction deviation of 1 mm, would let pass: a reversal is no corner.
///
/// Limits that the program lowers are judged, too; where it changes them on the way, by the highest of each kind, which no motion
/// of it exceeds.
///
/// @param machine  its period serves files without a time column; a difference to it is a note
/// @return Errors: of reading; input (setpoints-empty, setpoints-axes: the program moves axes that the file lacks);
///         cancelled
Result<VerifyReport> verify(SetpointFile& file, const Machine& machine, const ProgrammedPath* program = nullptr,
                            const VerifyOptions& options = {});

}  // namespace toolpace
