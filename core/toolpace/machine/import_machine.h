#pragma once
/// Machines as other controllers keep them.

#include <string>
#include <string_view>

#include "toolpace/base/result.h"
#include "toolpace/machine/setup.h"

namespace toolpace {

/// A LinuxCNC .ini: [TRAJ] MAX_LINEAR_VELOCITY, MAX_LINEAR_ACCELERATION, [EMCMOT] SERVO_PERIOD (ns), and of each
/// [AXIS_X] MAX_VELOCITY, MAX_ACCELERATION, MAX_JERK, MIN_LIMIT, MAX_LIMIT (else of its [JOINT_n]). LINEAR_UNITS inch
/// is converted. What the file does not say keeps its value of `base`. Errors (input): "import-empty" where no known
/// key stands in it.
Result<Setup> import_linuxcnc_ini(std::string_view text, const std::string& name, const Setup& base);

/// What grbl answers to $$: $11 junction deviation, $100–$102 steps/mm, $110–$112 mm/min, $120–$122 mm/s², $130–$132
/// travel mm (from −travel to 0, as grbl's machine space is). Other lines are passed over. Errors (input):
/// "import-empty".
Result<Setup> import_grbl_dump(std::string_view text, const std::string& name, const Setup& base);

}  // namespace toolpace
