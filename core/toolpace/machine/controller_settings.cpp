#include "toolpace/machine/controller_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "toolpace/base/numbers.h"
#include "toolpace/machine/joint_axes.h"
#include "toolpace/machine/read_machine.h"
#include "toolpace/machine/settings_includes.h"
#include "toolpace/machine/settings_kind.h"
#include "toolpace/machine/setup_keys.h"
#include "toolpace/machine/startup_code.h"

namespace toolpace {
namespace {

constexpr std::size_t kShownLetters = 40;  // letters of a value in a message

Error settings_error(std::string code, std::string message, std::string remedy, Location where) {
  return {ErrorKind::usage, std::move(code), std::move(message), std::move(remedy), std::move(where), {}};
}

/// The key as the file has it.
std::string shown_key(const std::string& key, Controller controller) {
  if (controller != Controller::klipper && controller != Controller::linuxcnc) return key;
  const std::size_t dot = key.rfind('.');
  return dot == std::string::npos ? key : "[" + key.substr(0, dot) + "] " + key.substr(dot + 1);
}

/// Fills settings from values by their table.
class Filling {
 public:
  Filling(ControllerSettings& settings, const ImportedValues& values, const std::string& name)
      : settings_(settings), values_(values), name_(name) {}

  Result<void> take_all() {
    for (const ControllerParameter& parameter : parameters(settings_)) {
      if (auto fine = take(parameter); !fine) return fine;
    }
    return {};
  }

  bool has(const std::string& key) const { return values_.contains(key); }

  Result<void> take(const ControllerParameter& parameter) {
    const std::string key = key_in_values(parameter.key, settings_.controller);
    const auto at = values_.find(key);
    if (at == values_.end()) {
      settings_.defaulted.push_back(parameter.key);
      return {};
    }
    settings_.used.push_back(parameter.key);
    taken_.push_back(key);
    warn_of_two(at->second, parameter.key);
    const auto number = number_of(at->second.text);
    if (!number) {
      return tl::unexpected(settings_error(
          "import-value",
          fmt::format("{} is '{}', which is no number", parameter.key, at->second.text.substr(0, kShownLetters)),
          "correct the controller's settings", {name_, at->second.line, 0}));
    }
    if (!(*number >= parameter.least && *number <= parameter.most)) {
      return tl::unexpected(
          settings_error("import-value",
                         fmt::format("{} is {}, but it must be from {} to {}", parameter.key, to_text(*number),
                                     to_text(parameter.least), to_text(parameter.most)),
                         "correct the controller's settings", {name_, at->second.line, 0}));
    }
    *parameter.value = *number * parameter.size;
    return {};
  }

  /// Sorts the keys that nothing asked for. @param known  what the controller has
  template <class Known>
  void tell_rest(const Known& known) {
    for (const auto& [key, value] : values_) {
      if (key.ends_with('.') || std::find(taken_.begin(), taken_.end(), key) != taken_.end()) continue;  // or a section
      (known(key) ? settings_.unused : settings_.unknown).push_back(shown_key(key, settings_.controller));
    }
  }

  void note_taken(std::string key) { taken_.push_back(std::move(key)); }

  /// Where a key of an .ini has two values.
  void warn_of_two(const ImportedValue& value, const std::string& key) {
    if (!value.again) return;
    settings_.warnings.push_back(
        {Severity::warning,
         "settings-twice",
         fmt::format("{} has another value in line {}: the first one counts", key, *value.again),
         "",
         {name_, value.line, 0},
         {}});
  }

  static std::optional<double> number_of(const std::string& text) {
    return parse_number(std::string_view(text).substr(0, text.find_first_of(" \t;#(")));
  }

 private:
  ControllerSettings& settings_;
  const ImportedValues& values_;
  const std::string& name_;
  std::vector<std::string> taken_;
};

std::string list_text(const std::vector<std::string>& keys) {
  std::string text;
  for (const std::string& key : keys) text += (text.empty() ? "" : ", ") + key;
  return text;
}

/// What a file leaves open is said; nothing of it is wrong.
void warn_of_the_rest(ControllerSettings& s, const std::string& name) {
  const auto warn = [&](const char* code, const std::string& what, const std::vector<std::string>& keys) {
    if (keys.empty()) return;
    s.warnings.push_back({Severity::warning, code, fmt::format("{}: {}", what, list_text(keys)), "", {name, 0, 0}, {}});
  };
  const std::string title(controller_title(s.controller));
  warn("settings-defaulted", "not in the file, so " + title + "'s own default holds", s.defaulted);
  warn("settings-not-known", title + " has no such settings", s.unknown);
}

Result<void> fill_grbl(ControllerSettings& s, const ImportedValues& values, const std::string& name) {
  GrblSettings& grbl = s.values.emplace<GrblSettings>();
  const bool is_hal = s.controller == Controller::grblhal;
  if (is_hal) grbl.buffer = 100;
  Filling filling(s, values, name);
  if (auto fine = filling.take_all(); !fine) return fine;
  filling.tell_rest([&](const std::string& key) { return is_hal || is_setting_of_grbl(key); });
  // Whether $32 or the ring's size stands in a dump is of the firmware's version: no news to anybody.
  std::erase_if(s.defaulted, [](const std::string& key) { return key == "$398" || key == "$32"; });
  return {};
}

/// Moves of the extruder alone may feed as much as the widest line takes. @source Klipper, klippy/kinematics/extruder.py
void set_extruder_defaults(KlipperSettings& k) {
  const double area = 0.25 * std::numbers::pi * k.filament * k.filament, ratio = 4.0 * k.nozzle * k.nozzle / area;
  if (k.max_extrude_only_velocity == 0) k.max_extrude_only_velocity = k.max_velocity * ratio;
  if (k.max_extrude_only_accel == 0) k.max_extrude_only_accel = k.max_accel * ratio;
}

/// Sections of a printer.cfg are without number; of those that count here the keys are known.
/// @source Klipper, klippy/toolhead.py, klippy/kinematics/, klippy/extras/gcode_arcs.py
bool is_key_of_klipper(const std::string& key) {
  constexpr std::array<std::string_view, 11> kOthers = {
      "kinematics",   "max_accel_to_decel", "minimum_z_position", "delta_radius",    "print_radius",    "arm_length",
      "arm_x_length", "move_flush_time",    "buffer_time_start",  "buffer_time_low", "buffer_time_high"};
  constexpr std::string_view kPrinter = "printer.";
  if (key.starts_with("gcode_arcs.")) return false;
  if (!key.starts_with(kPrinter)) return true;
  return std::find(kOthers.begin(), kOthers.end(), std::string_view(key).substr(kPrinter.size())) != kOthers.end();
}

Result<void> fill_klipper(ControllerSettings& s, const ImportedValues& values, const std::string& name) {
  KlipperSettings& k = s.values.emplace<KlipperSettings>();
  const auto has_section = [&](std::string_view section) {
    return std::any_of(values.begin(), values.end(), [&](const auto& v) { return v.first.starts_with(section); });
  };
  k.has_extruder = has_section("extruder.");
  k.has_arcs = has_section("gcode_arcs.");
  Filling filling(s, values, name);
  if (auto fine = filling.take_all(); !fine) return fine;
  for (const char* key : {"max_velocity", "max_accel"}) {
    if (filling.has(std::string("printer.") + key)) continue;
    return tl::unexpected(settings_error("settings-missing",
                                         fmt::format("[printer] has no {}, which Klipper asks for", key),
                                         "give the printer.cfg that has it", {name, 0, 0}));
  }
  const auto is_missing = [&](const char* key) { return !filling.has(std::string("printer.") + key); };
  if (k.has_extruder) set_extruder_defaults(k);
  if (is_missing("max_z_velocity")) k.max_z_velocity = k.max_velocity;
  if (is_missing("max_z_accel")) k.max_z_accel = k.max_accel;
  // Until 2024 the ratio was told as an acceleration.
  const auto old = values.find("printer.max_accel_to_decel");
  if (is_missing("minimum_cruise_ratio") && old != values.end()) {
    filling.note_taken("printer.max_accel_to_decel");
    s.used.emplace_back("[printer] max_accel_to_decel");
    std::erase(s.defaulted, "[printer] minimum_cruise_ratio");
    const auto number = Filling::number_of(old->second.text);
    if (!number || !(*number > 0)) {
      return tl::unexpected(settings_error("import-value", "[printer] max_accel_to_decel is no number above 0",
                                           "correct the controller's settings", {name, old->second.line, 0}));
    }
    k.minimum_cruise_ratio = 1.0 - std::min(1.0, *number / k.max_accel);
  }
  if (const auto at = values.find("printer.kinematics"); at != values.end()) {
    k.kinematics = at->second.text;
    filling.note_taken("printer.kinematics");
    s.used.emplace_back("[printer] kinematics");
  }
  constexpr std::array<std::string_view, 4> kStraight = {"cartesian", "corexy", "corexz", "hybrid_corexy"};
  if (std::find(kStraight.begin(), kStraight.end(), k.kinematics) == kStraight.end()) {
    s.warnings.push_back(
        {Severity::warning,
         "settings-kinematics",
         fmt::format("kinematics '{}' may have limits of their own, which are not counted", k.kinematics),
         "",
         {name, 0, 0},
         {}});
  }
  filling.tell_rest(is_key_of_klipper);
  return {};
}

Result<void> fill_marlin(ControllerSettings& s, const ImportedValues& values, const std::string& name) {
  s.values.emplace<MarlinSettings>();
  if (const auto inches = values.find(kInchesOfMarlin); inches != values.end()) {
    return tl::unexpected(settings_error("import-value", "this report of M503 is in inches (G20)",
                                         "send G21, then M503 again", {name, inches->second.line, 0}));
  }
  Filling filling(s, values, name);
  if (auto fine = filling.take_all(); !fine) return fine;
  filling.tell_rest([](const std::string&) { return true; });
  if (!filling.has("M205 J") && filling.has("M205 X")) {
    s.warnings.push_back({Severity::warning,
                          "settings-classic-jerk",
                          "corners go by classic jerk (M205 X Y Z) there, which is not modelled: the default junction "
                          "deviation is taken",
                          "give M205 J of a firmware with junction deviation",
                          {name, 0, 0},
                          {}});
  }
  return {};
}

/// Axes that are there and have no limits get LinuxCNC's own, which are so low that nobody means them.
/// @source LinuxCNC 2.9, emc/nml_intf/emccfg.h, DEFAULT_AXIS_MAX_VELOCITY, DEFAULT_AXIS_MAX_ACCELERATION
void set_axis_defaults(ControllerSettings& s, LinuxcncSettings& l, const ImportedValues& values,
                       const std::string& name) {
  Importer importer(values, name);
  const ImportedValue* const coordinates = importer.find("TRAJ.COORDINATES");
  if (!coordinates) return;
  const JointAxes joints = joint_axes(importer);
  const std::string letters = upper(coordinates->text.substr(0, coordinates->text.find_first_of("#;")));
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    if (letters.find(kAxisNames[k]) == std::string::npos) continue;
    const double unit = is_rotary(k) ? kRadiansPerDegree : length_unit(importer);
    const auto set = [&](AxisVector& limits, const std::string& key) {
      if (!keys_of_axis(importer, joints, k, "." + key).empty()) return;
      limits[static_cast<Eigen::Index>(k)] = unit;  // 1 of the file's
      s.defaulted.push_back(std::string("[AXIS_") + kAxisNames[k] + "] " + key);
    };
    set(l.axis_velocity, "MAX_VELOCITY");
    set(l.axis_acceleration, "MAX_ACCELERATION");
  }
}

Result<void> fill_linuxcnc(ControllerSettings& s, const ImportedValues& values, const std::string& name) {
  // Which limit is which axis', and in which unit, the import of machines knows.
  const auto setup = import_linuxcnc_values(values, name);
  if (!setup) return tl::unexpected(setup.error());
  LinuxcncSettings& l = s.values.emplace<LinuxcncSettings>();
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    l.axis_velocity[static_cast<Eigen::Index>(k)] = setup->machine.axes[k].speed;
    l.axis_acceleration[static_cast<Eigen::Index>(k)] = setup->machine.axes[k].acceleration;
  }
  l.velocity = setup->machine.path.speed;
  l.period = setup->machine.period;
  s.warnings = setup->warnings;
  Filling filling(s, values, name);
  for (const ControllerParameter& p : parameters(s)) {
    const bool is_imported =
        p.key.ends_with("VELOCITY") || p.key.ends_with("ACCELERATION") || p.key.ends_with("PERIOD");
    if (!is_imported) {
      if (auto fine = filling.take(p); !fine) return fine;
      continue;
    }
    const std::string key = key_in_values(p.key, s.controller);
    filling.note_taken(key);
    if (!filling.has(key)) continue;
    s.used.push_back(p.key);
    filling.warn_of_two(values.at(key), p.key);
  }
  if (const auto at = values.find("RS274NGC.RS274NGC_STARTUP_CODE"); at != values.end()) {
    l.startup_code = at->second.text;
    l.blend_tolerance = read_startup_code(l.startup_code).tolerance.value_or(0.0);
    filling.note_taken(at->first);
    s.used.emplace_back("[RS274NGC] RS274NGC_STARTUP_CODE");
  }
  s.defaulted.clear();  // every .ini leaves most keys out
  set_axis_defaults(s, l, values, name);
  if (!(l.axis_velocity.minCoeff() < kUnlimited)) {
    return tl::unexpected(settings_error(
        "settings-missing", "no axis has a MAX_VELOCITY in [AXIS_X] and so on, which LinuxCNC 2.9 asks for",
        "give the .ini that has it", {name, 0, 0}));
  }
  filling.tell_rest([](const std::string&) { return true; });
  return {};
}

Result<void> fill_values(ControllerSettings& s, const ImportedValues& values, const std::string& name) {
  switch (s.controller) {
    case Controller::klipper: return fill_klipper(s, values, name);
    case Controller::marlin: return fill_marlin(s, values, name);
    case Controller::linuxcnc: return fill_linuxcnc(s, values, name);
    default: return fill_grbl(s, values, name);
  }
}

Error unknown_settings(std::string_view text, const std::string& name) {
  const std::string_view kind = kind_of_other_text(text);
  return settings_error("settings-unknown",
                        kind.empty()
                            ? "these are no settings of a controller that is known"
                            : fmt::format("these are no settings of a controller that is known: this is {}", kind),
                        "give an answer to $$, a printer.cfg, a report of M503 or a LinuxCNC .ini", {name, 0, 0});
}

bool is_same_form(Controller a, Controller b) {
  const auto is_grbl = [](Controller c) { return c == Controller::grbl || c == Controller::grblhal; };
  return a == b || (is_grbl(a) && is_grbl(b));
}

}  // namespace

Result<ControllerSettings> parse_controller_settings(std::string_view text, const std::string& name,
                                                     std::optional<Controller> controller,
                                                     const ReadIncluded& included) {
  const auto told = controller_of_settings(text);
  if (!told || is_reprapfirmware(text)) return tl::unexpected(unknown_settings(text, name));
  if (controller && !is_same_form(*controller, *told)) {
    return tl::unexpected(settings_error(
        "settings-foreign",
        fmt::format("these are settings of {}, not of {}", controller_title(*told), controller_title(*controller)),
        fmt::format("give --controller {}, or another file", controller_name(*told)), {name, 0, 0}));
  }
  ControllerSettings settings;
  settings.controller = controller.value_or(*told);
  if (auto fine = fill_values(settings, read_controller_values(text, settings.controller, included), name); !fine) {
    return tl::unexpected(fine.error());
  }
  warn_of_the_rest(settings, name);
  return settings;
}

Result<ControllerSettings> read_controller_settings(const std::filesystem::path& file,
                                                    std::optional<Controller> controller, const Monitor& monitor) {
  const auto text = read_settings_text(file, monitor);
  if (!text) return tl::unexpected(text.error());
  IncludedFiles included(file, monitor);
  auto settings = parse_controller_settings(*text, file.string(), controller, included.reader());
  if (included.error()) return tl::unexpected(*included.error());
  return settings;
}

}  // namespace toolpace
