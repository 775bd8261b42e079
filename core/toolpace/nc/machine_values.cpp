#include "toolpace/nc/machine_values.h"

#include "toolpace/nc/motion/motion.h"

namespace toolpace::nc {
namespace {

constexpr int kNamedSystems = 6;                 // G54 to G59
constexpr double kMillisecondsPerLine = 1000.0;  // of the clock #3001: programs wait for it, and do not measure by it

double in_units(const Modal& modal, double value, std::size_t axis) {
  return is_rotary(axis) ? value : value / modal.unit();
}

int axis_of(char letter) {
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    if (kAxisLetters[i] == letter) return static_cast<int>(i);
  }
  return -1;
}

std::optional<double> position_by_name(const State& state, std::string_view name) {
  const bool absolute = name.rfind("_abs_", 0) == 0;
  const std::string_view letter = name.substr(absolute ? 5 : 1);
  if (letter.size() != 1) return std::nullopt;
  const int axis = axis_of(letter.front());
  if (axis < 0) return letter == "u" || letter == "v" || letter == "w" ? std::optional(0.0) : std::nullopt;
  const auto i = static_cast<std::size_t>(axis);
  const Position& p = programmed_position(state);
  return in_units(state.modal, absolute ? to_machine(state.offsets, p)[i] : p[i], i);
}

std::optional<double> fanuc_value(const State& state, int index) {
  const Modal& modal = state.modal;
  const Position& p = programmed_position(state);
  const auto axis = [&](int first) { return static_cast<std::size_t>(index - first); };
  if (index >= 5001 && index <= 5006) return in_units(modal, p[axis(5001)], axis(5001));
  if (index >= 5021 && index <= 5026) return in_units(modal, to_machine(state.offsets, p)[axis(5021)], axis(5021));
  if (index >= 5041 && index <= 5046) return in_units(modal, p[axis(5041)], axis(5041));
  if (index >= 5081 && index <= 5086) return in_units(modal, state.offsets.tool_length[axis(5081)], axis(5081));
  if (index >= 4201 && index <= 4220) index -= 200;  // those of the block that runs
  switch (index) {
    case 4001: return (modal.motion >= kForeignCodes ? modal.motion - kForeignCodes : modal.motion) / 10.0;
    case 4002: return modal.plane / 10.0;
    case 4003: return modal.distance / 10.0;
    case 4005: return modal.feed_mode / 10.0;
    case 4006: return modal.units / 10.0;
    case 4007: return modal.compensation / 10.0;
    case 4008: return modal.tool_length / 10.0;
    case 4010: return modal.retract / 10.0;
    case 4012:
    case 4014: return modal.system <= kNamedSystems ? 53.0 + modal.system : 54.1;
    case 4109: return modal.feed;
    case 4119: return modal.spindle_speed;
    case 4120: return state.selected_tool;
    default: return std::nullopt;
  }
}

}  // namespace

std::optional<double> MachineValues::numbered(int index) const {
  if (rules_.macro_statements) {
    if (index == 3001) return kMillisecondsPerLine * static_cast<double>(flow_.work());
    if (const auto value = fanuc_value(state_, index)) return value;
  }
  if (index >= 5420 && index <= 5425) {
    const auto axis = static_cast<std::size_t>(index - 5420);
    return in_units(state_.modal, programmed_position(state_)[axis], axis);
  }
  if (index >= 5401 && index <= 5406) return state_.offsets.tool_length[static_cast<std::size_t>(index - 5401)];
  switch (index) {
    case 5400: return state_.loaded.number;
    case 5410: return state_.loaded.diameter;
    case 5411: return state_.loaded.front_angle;
    case 5412: return state_.loaded.back_angle;
    case 5413: return state_.loaded.orientation;
    default: return std::nullopt;
  }
}

std::optional<double> MachineValues::named(std::string_view name) const {
  if (name.empty() || name.front() != '_') return std::nullopt;
  const Modal& m = state_.modal;
  const auto flag = [](bool value) { return std::optional(value ? 1.0 : 0.0); };
  if (const auto position = position_by_name(state_, name)) return position;
  struct Value {
    std::string_view name;
    double value;
  };
  const Value values[] = {
      {"_value", flow_.returned_value()},
      {"_value_returned", flow_.has_returned_value() ? 1.0 : 0.0},
      {"_line", static_cast<double>(flow_.line_number())},
      {"_motion_mode", static_cast<double>(m.motion)},
      {"_plane", static_cast<double>(m.plane)},
      {"_ccomp", static_cast<double>(m.compensation)},
      {"_coord_system", static_cast<double>(m.system <= 6 ? 530 + 10 * m.system : 584 + m.system)},
      {"_feed", m.feed},
      {"_rpm", m.spindle_speed},
      {"_current_tool", static_cast<double>(state_.loaded.number)},
      {"_current_pocket", static_cast<double>(state_.loaded.pocket)},
      {"_selected_tool", static_cast<double>(state_.selected_tool)},
      {"_call_level", static_cast<double>(flow_.depth())},
      {"_remap_level", 0.0},
      {"_vmajor", 2.9},
      {"_vminor", 0.0},
  };
  for (const auto& entry : values) {
    if (entry.name == name) return entry.value;
  }
  if (name == "_metric") return flag(m.units == 210);
  if (name == "_imperial") return flag(m.units == 200);
  if (name == "_absolute") return flag(m.distance == 900);
  if (name == "_incremental") return flag(m.distance == 910);
  if (name == "_inverse_time") return flag(m.feed_mode == 930);
  if (name == "_units_per_minute") return flag(m.feed_mode == 940);
  if (name == "_units_per_rev") return flag(m.feed_mode == 950);
  if (name == "_tool_offset") return flag(m.tool_length != 490);
  if (name == "_retract_r_plane") return flag(m.retract == 990);
  if (name == "_retract_old_z") return flag(m.retract == 980);
  if (name == "_spindle_rpm_mode") return flag(m.spindle_mode == 970);
  if (name == "_spindle_css_mode") return flag(m.spindle_mode == 960);
  if (name == "_ijk_absolute_mode") return flag(m.arc_distance == 901);
  if (name == "_lathe_diameter_mode") return flag(m.lathe_diameter == 70);
  if (name == "_lathe_radius_mode") return flag(m.lathe_diameter == 80);
  if (name == "_spindle_on") return flag(m.spindle_direction != 0);
  if (name == "_spindle_cw") return flag(m.spindle_direction > 0);
  if (name == "_mist") return flag(m.mist);
  if (name == "_flood") return flag(m.flood);
  if (name == "_speed_override" || name == "_feed_override") return 1.0;
  if (name == "_adaptive_feed" || name == "_feed_hold" || name == "_task") return 0.0;
  return std::nullopt;
}

}  // namespace toolpace::nc
