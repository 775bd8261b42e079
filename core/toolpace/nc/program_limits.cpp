#include "toolpace/nc/program_limits.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>

namespace toolpace::nc {
namespace {

constexpr std::size_t kLinearAxes = 3;

void apply(Context& context) {
  const ProgramLimits& limits = context.state.limits;
  MotionCeiling travelling = limits.ceiling;
  travelling.path_acceleration = limits.travel_acceleration;
  context.out.set_ceilings(limits.ceiling, travelling);
  context.out.set_mode(context.state.modal);
}

void tell_unused(Context& context, const std::string& what, std::size_t column) {
  if (std::exchange(context.state.limits.unused_told, true)) return;
  context.faults.warn("limit-without-effect", fmt::format("{} has no effect on plans here", what), "", column);
}

/// A limit that a machine could move under; else it is left as it was, with a warning.
bool is_limit(Context& context, double value, bool may_be_zero, std::size_t column) {
  if (value > 0.0 || (may_be_zero && value == 0.0)) return true;
  context.faults.warn("limit-not-positive", fmt::format("a limit of {:g} is left out", value), "give one above 0",
                      column);
  return false;
}

void set_axes(Context& context, const Block& block, AxisVector& limits, bool may_be_zero) {
  for (std::size_t k = 0; k < kLinearAxes; ++k) {
    const char letter = kAxisLetters[k];
    if (!block.has(letter)) continue;
    const double value = block.of(letter) * context.state.modal.unit();
    if (is_limit(context, value, may_be_zero, block.column_of(letter))) limits[static_cast<Eigen::Index>(k)] = value;
  }
}

void set_value(Context& context, const Block& block, char letter, double& limit, bool may_be_zero = false) {
  if (!block.has(letter)) return;
  const double value = block.of(letter) * context.state.modal.unit();
  if (is_limit(context, value, may_be_zero, block.column_of(letter))) limit = value;
}

/// P of prints, T of travels; S, as older firmware has it, of both. R is of the extruder alone.
void set_accelerations(Context& context, const Block& block) {
  ProgramLimits& limits = context.state.limits;
  double printing = limits.ceiling.path_acceleration, travelling = limits.travel_acceleration;
  set_value(context, block, 's', printing);
  if (block.has('s') && !block.has('t')) travelling = printing;
  set_value(context, block, 'p', printing);
  set_value(context, block, 't', travelling);
  limits.ceiling.path_acceleration = printing;
  limits.travel_acceleration = travelling;
}

void set_corners(Context& context, const Block& block) {
  MotionCeiling& ceiling = context.state.limits.ceiling;
  set_axes(context, block, ceiling.corner_step, true);
  set_value(context, block, 'j', ceiling.junction_deviation, true);
  for (const char letter : {'s', 't', 'b'}) {
    if (block.has(letter))
      tell_unused(context, fmt::format("{} of M205", static_cast<char>(letter - 'a' + 'A')), block.column_of(letter));
  }
}

/// NAME=VALUE
struct Setting {
  std::string name;
  double value = 0.0;
  std::size_t column = 0;
};

std::optional<Setting> take_setting(Scanner& text) {
  Setting setting;
  char c = text.peek();
  setting.column = text.column();
  for (; is_letter(c) || c == '_'; c = text.peek()) {
    setting.name.push_back(c);
    text.take();
  }
  if (setting.name.empty() || c != '=') return std::nullopt;
  text.take();
  if (text.take_number(setting.value) != NumberStatus::ok) return std::nullopt;
  return setting;
}

void set_velocity(Context& context, const Setting& setting) {
  ProgramLimits& limits = context.state.limits;
  const bool is_corner = setting.name == "square_corner_velocity";
  if (setting.name == "accel_to_decel" || setting.name == "minimum_cruise_ratio") {
    return tell_unused(context, setting.name == "accel_to_decel" ? "ACCEL_TO_DECEL" : "MINIMUM_CRUISE_RATIO",
                       setting.column);
  }
  if (setting.name != "velocity" && setting.name != "accel" && !is_corner) {
    return tell_unused(context, "a word of SET_VELOCITY_LIMIT that is not known", setting.column);
  }
  if (!is_limit(context, setting.value, is_corner, setting.column)) return;
  if (is_corner) limits.ceiling.corner_speed = setting.value;
  if (setting.name == "velocity") limits.ceiling.path_speed = setting.value;
  if (setting.name == "accel") limits.ceiling.path_acceleration = limits.travel_acceleration = setting.value;
}

}  // namespace

void set_overrides(Context& context, const Block& block) {
  Modal& modal = context.state.modal;
  switch (block.code(MGroup::override_)) {
    case 48: modal.holds_overrides = false; break;
    case 49: modal.holds_overrides = true; break;
    case 50: modal.holds_overrides = block.has('p') && block.of('p') == 0.0; break;
    default: break;
  }
}

void set_program_limits(Context& context, const Block& block) {
  MotionCeiling& ceiling = context.state.limits.ceiling;
  switch (block.code(MGroup::limits)) {
    case 201: set_axes(context, block, ceiling.acceleration, false); break;
    case 203: set_axes(context, block, ceiling.speed, false); break;
    case 204: set_accelerations(context, block); break;
    default: set_corners(context, block); break;
  }
  apply(context);
}

void set_accuracy(Context& context, double accuracy) {
  context.state.limits.ceiling.accuracy = accuracy;
  apply(context);
}

bool run_velocity_limit(Context& context, Scanner text) {
  if (!text.take_word("set_velocity_limit")) return false;
  while (const auto setting = take_setting(text)) set_velocity(context, *setting);
  apply(context);
  return true;
}

}  // namespace toolpace::nc
