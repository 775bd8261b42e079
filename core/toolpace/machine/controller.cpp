#include "toolpace/machine/controller.h"

#include <algorithm>
#include <array>

#include "toolpace/machine/settings_text.h"

namespace toolpace {
namespace {

struct Names {
  Controller controller;
  std::string_view name, title;
};

constexpr std::array<Names, 5> kNames = {{{Controller::grbl, "grbl", "grbl"},
                                          {Controller::grblhal, "grblhal", "grblHAL"},
                                          {Controller::klipper, "klipper", "Klipper"},
                                          {Controller::marlin, "marlin", "Marlin"},
                                          {Controller::linuxcnc, "linuxcnc", "LinuxCNC"}}};

constexpr std::array<Controller, 5> kAll = {Controller::grbl, Controller::grblhal, Controller::klipper,
                                            Controller::marlin, Controller::linuxcnc};

bool has_section(std::string_view line, std::string_view section) {
  return line.starts_with(section) && line.size() > section.size();
}

/// What one line tells.
std::optional<Controller> told_by(std::string_view line) {
  constexpr std::array<std::string_view, 6> kLinuxcnc = {"[EMC]", "[TRAJ]", "[EMCMOT]", "[KINS]", "[AXIS_", "[JOINT_"};
  constexpr std::array<std::string_view, 5> kKlipper = {"[printer]", "[mcu", "[stepper_", "[gcode_arcs]", "[include "};
  const auto starts = [&](std::string_view section) { return line.starts_with(section); };
  if (std::any_of(kLinuxcnc.begin(), kLinuxcnc.end(), starts)) return Controller::linuxcnc;
  if (std::any_of(kKlipper.begin(), kKlipper.end(), starts)) return Controller::klipper;
  if (const auto setting = grbl_setting_in(line))
    return is_setting_of_grbl(setting->first) ? Controller::grbl : Controller::grblhal;
  const auto report = marlin_words_in(line);
  if (report && (has_section(line, "echo:") || report->words.size() > 1)) return Controller::marlin;
  return std::nullopt;
}

/// Of dumps whose keys and values stand in different lines.
std::optional<Controller> told_by_values(const ImportedValues& values) {
  if (values.empty()) return std::nullopt;
  const auto is_old = [](const auto& value) { return is_setting_of_grbl(value.first); };
  return std::all_of(values.begin(), values.end(), is_old) ? Controller::grbl : Controller::grblhal;
}

/// The greeting that stands above a dump, or the answer to $I, where no setting of its own does.
bool says_grblhal(std::string_view text) {
  return text.find("GrblHAL 1.") != std::string_view::npos || text.find("[FIRMWARE:grblHAL") != std::string_view::npos;
}

}  // namespace

std::string_view controller_name(Controller controller) { return kNames[static_cast<std::size_t>(controller)].name; }

std::string_view controller_title(Controller controller) { return kNames[static_cast<std::size_t>(controller)].title; }

std::optional<Controller> controller_named(std::string_view name) {
  const auto at = std::find_if(kNames.begin(), kNames.end(), [&](const Names& n) { return n.name == name; });
  return at == kNames.end() ? std::nullopt : std::optional(at->controller);
}

std::span<const Controller> all_controllers() { return kAll; }

bool reads_own_disk(Controller controller) {
  return controller == Controller::klipper || controller == Controller::linuxcnc;
}

std::optional<Controller> controller_of_settings(std::string_view text) {
  std::optional<Controller> found;
  for_each_line(text, [&](std::string_view line, std::size_t) {
    if (found && *found != Controller::grbl) return;  // a dump of grbl may still turn out to be grblHAL's
    const auto told = told_by(line);
    if (told && (!found || *told == Controller::grblhal)) found = told;
  });
  if (!found) found = told_by_values(read_grbl_values(text));
  if (found == Controller::grbl && says_grblhal(text)) return Controller::grblhal;
  return found;
}

}  // namespace toolpace
