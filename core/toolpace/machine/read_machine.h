#pragma once
/// Machines as files keep them, ours and those of other controllers: the one way in for the command line and the window.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "toolpace/base/result.h"
#include "toolpace/machine/importer.h"
#include "toolpace/machine/setup.h"

namespace toolpace {

enum class MachineFormat : std::uint8_t { toml, linuxcnc, grbl, klipper, marlin };

/// By the extension (.toml, .ini; in any case), else by what stands in the text: lines such as $110=6000 are grbl's,
/// a section that LinuxCNC knows is its, and as controller_of_settings() tells. Everything else is TOML.
MachineFormat machine_format(const std::filesystem::path& name, std::string_view text);

/// Klipper's and Marlin's settings are those of controller_setup().
/// Errors: of parse_setup(), import_linuxcnc_ini(), import_grbl_dump(), parse_controller_settings().
Result<Setup> parse_machine(std::string_view text, const std::string& name);
/// Errors: io, cancelled, those of parse_machine().
Result<Setup> read_machine(const std::filesystem::path& file, const Monitor& monitor = {});

/// A LinuxCNC .ini: [TRAJ] MAX_LINEAR_VELOCITY, MAX_LINEAR_ACCELERATION, MAX_LINEAR_JERK, [EMCMOT] SERVO_PERIOD (ns), and
/// of each [AXIS_X] MAX_VELOCITY, MAX_ACCELERATION, MAX_JERK, MIN_LIMIT, MAX_LIMIT; what an axis lacks is that of the
/// [JOINT_n] that moves it (joint_axes.h), of several the strictest. Which joint that is may not be told: the setup
/// then has the warning "joint-axis-guessed" or, where joints are no axes and so are left out, "joint-axis-unknown".
/// LINEAR_UNITS inch is converted; limits of 1e9 and more are none, a jerk of 0 is none. Without any jerk limit the law is the
/// trapezoid, as LinuxCNC plans. Errors (usage), with file and line: "import-value" for what is no number, out of the
/// range of a machine file or, as travel, out of order; (input) "import-empty" where no known key stands in it.
Result<Setup> import_linuxcnc_ini(std::string_view text, const std::string& name);
/// The same of values that were read already (settings_text.h).
Result<Setup> import_linuxcnc_values(ImportedValues values, const std::string& name);

/// What grbl answers to $$: $11 junction deviation, $100–$102 steps/mm, $110–$112 mm/min, $120–$122 mm/s², $130–$132
/// travel mm (from −travel to 0, as grbl's machine space is; 0 = none). Other lines are passed over, and so is what a
/// console or a sender puts around these; of several dumps the last one counts. The law is the
/// trapezoid, as grbl plans. Errors: as above.
Result<Setup> import_grbl_dump(std::string_view text, const std::string& name);

}  // namespace toolpace
