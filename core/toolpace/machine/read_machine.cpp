#include "toolpace/machine/read_machine.h"

#include <algorithm>
#include <array>

#include "toolpace/base/file_name.h"
#include "toolpace/machine/controller_machine.h"
#include "toolpace/machine/settings_text.h"

namespace toolpace {
namespace {

bool is_grbl_setting(std::string_view line) {
  return !line.starts_with('#') && grbl_setting_in(trimmed(line)).has_value();
}

/// [TRAJ] and its like; machine files have no such sections.
bool is_linuxcnc_section(std::string_view line) {
  constexpr std::array<std::string_view, 6> kSections = {"[EMC]", "[TRAJ]", "[EMCMOT]", "[KINS]", "[AXIS_", "[JOINT_"};
  return std::any_of(kSections.begin(), kSections.end(), [&](auto section) { return line.starts_with(section); });
}

}  // namespace

MachineFormat machine_format(const std::filesystem::path& name, std::string_view text) {
  const std::string extension = extension_of(name);
  const std::string_view all = text;
  if (extension == ".toml") return MachineFormat::toml;
  if (extension == ".ini") return MachineFormat::linuxcnc;
  while (!text.empty()) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) break;
    text.remove_prefix(begin);
    const std::string_view line = text.substr(0, text.find('\n'));
    if (is_grbl_setting(line)) return MachineFormat::grbl;
    if (is_linuxcnc_section(line)) return MachineFormat::linuxcnc;
    text.remove_prefix(line.size());
  }
  const auto controller = controller_of_settings(all);
  // Keys and values of JSON may stand in different lines; no TOML begins like that.
  const bool is_json = trimmed(all).starts_with('{') || trimmed(all).starts_with("[{");
  if (is_json && (controller == Controller::grbl || controller == Controller::grblhal)) return MachineFormat::grbl;
  if (controller == Controller::klipper) return MachineFormat::klipper;
  return controller == Controller::marlin ? MachineFormat::marlin : MachineFormat::toml;
}

namespace {

/// The limits of a controller, with what its settings leave open.
Result<Setup> import_controller(const Result<ControllerSettings>& settings) {
  if (!settings) return tl::unexpected(settings.error());
  Setup setup = controller_setup(*settings);
  setup.warnings = settings->warnings;
  if (auto fine = check_setup(setup.machine, setup.options); !fine) return tl::unexpected(fine.error());
  return setup;
}

}  // namespace

Result<Setup> parse_machine(std::string_view text, const std::string& name) {
  switch (machine_format(name, text)) {
    case MachineFormat::linuxcnc: return import_linuxcnc_ini(text, name);
    case MachineFormat::grbl: return import_grbl_dump(text, name);
    case MachineFormat::klipper:
    case MachineFormat::marlin: return import_controller(parse_controller_settings(text, name));
    case MachineFormat::toml: break;
  }
  return parse_setup(text, name);
}

Result<Setup> read_machine(const std::filesystem::path& file, const Monitor& monitor) {
  const auto text = read_settings_text(file, monitor);
  if (!text) return tl::unexpected(text.error());
  // Only files may include others.
  if (machine_format(file, *text) == MachineFormat::klipper)
    return import_controller(read_controller_settings(file, {}, monitor));
  return parse_machine(*text, file.string());
}

}  // namespace toolpace
