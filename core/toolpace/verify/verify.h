#pragma once
/// An independent proof of a setpoint file: nothing of it comes from planning.

#include "toolpace/base/monitor.h"
#include "toolpace/limits/machine.h"
#include "toolpace/verify/programmed_path.h"
#include "toolpace/verify/report.h"
#include "toolpace/verify/setpoint_file.h"

namespace toolpace {

/// Checks the file against the machine and, if given, the program. Reads the file once, or several times where it is
/// not on the path to 1e-6 mm. Bounded memory, whatever the file's length.
///
/// @param machine  its period serves files without a time column; a difference to it is a note
/// @return Errors: of reading; input (setpoints-empty, setpoints-axes: the program moves axes that the file lacks);
///         cancelled
Result<VerifyReport> verify(SetpointFile& file, const Machine& machine, const ProgrammedPath* program = nullptr,
                            const Monitor& monitor = {});

}  // namespace toolpace
