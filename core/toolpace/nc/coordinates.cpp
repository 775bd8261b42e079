#include "toolpace/nc/coordinates.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <iterator>

#include "toolpace/nc/motion/motion.h"
#include "toolpace/nc/text/whole_number.h"
#include "toolpace/nc/tool_table.h"

namespace toolpace::nc {
namespace {

// G54 … G59.3, then G54.1 P1 … P48 and P49 … P300 at the numbers that Fanuc gives them.
int first_parameter(int system) {
  if (system <= kSystemCount) return kFirstSystem + (system - 1) * kSystemStride;
  const int further = system - kSystemCount - 1;
  return (further < kNearSystems ? kFirstFurtherSystem : kFirstOfManySystems) + further * kSystemStride;
}

double word_value(const State& state, const Block& block, std::size_t axis) {
  const char letter = kAxisLetters[axis];
  if (is_rotary(axis)) return block.of(letter);
  const double value = length_of(state, block, letter);
  return axis == 0 && state.modal.lathe_diameter == 70 ? value / 2.0 : value;
}

bool refuse_with_compensation(Context& context, const Block& block, const char* what) {
  if (context.state.compensation.radius <= 0.0) return true;
  return context.faults.fail("offset-with-compensation", fmt::format("{} while cutter radius compensation is on", what),
                             "end it with G40 first", block.column_of(GGroup::once));
}

bool take_system_number(Context& context, const Block& block, int& system) {
  const double p = block.of('p', -1.0);
  if (!block.has('p')) {
    return context.faults.fail("g10-without-p", "G10 without P", "name the coordinate system with P",
                               block.column_of(GGroup::once));
  }
  if (context.rules.incremental_g10 && block.of('l', 2.0) == 20.0) {
    const auto further = whole_number(p, 1, kFurtherSystems);
    if (!further) {
      return context.faults.fail("g10-system", fmt::format("there is no coordinate system G54.1 P{:g}", p),
                                 "P1 to P300 are G54.1 P1 to P300", block.column_of('p'));
    }
    system = kSystemCount + *further;
    return true;
  }
  const auto number = whole_number(p, 0, kSystemCount);
  if (!number) {
    return context.faults.fail("g10-system", fmt::format("there is no coordinate system P{:g}", p),
                               "P0 is the active system, P1 to P9 are G54 to G59.3", block.column_of('p'));
  }
  system = *number == 0 ? context.state.modal.system : *number;
  return true;
}

bool set_system_origin(Context& context, const Block& block, bool from_position) {
  State& state = context.state;
  int system = 0;
  if (!take_system_number(context, block, system)) return false;
  if (from_position && block.has('r')) {
    return context.faults.fail("g10-rotation", "R with G10 L20", "set the rotation with G10 L2", block.column_of('r'));
  }
  const int first = first_parameter(system);
  Parameters& parameters = context.parameters;
  if (block.has('r') && !from_position) parameters.set_numbered(first + kRotationWithinSystem, block.of('r'));
  const Offsets old = system_offsets(context, system);
  Position origin = old.origin;
  if (from_position) {
    // The origin that makes the current point read the given values.
    const Position machine = to_machine(state.offsets, state.position);
    Position wanted = to_work(old, machine);
    for (std::size_t i = 0; i < kAxisCount; ++i) {
      if (block.has(kAxisLetters[i])) wanted[i] = word_value(state, block, i);
    }
    const Position there = to_machine(old, wanted);
    for (std::size_t i = 0; i < kAxisCount; ++i) origin[i] += machine[i] - there[i];
  } else {
    for (std::size_t i = 0; i < kAxisCount; ++i) {
      if (!block.has(kAxisLetters[i])) continue;
      const double value = word_value(state, block, i);
      origin[i] = context.rules.incremental_g10 && state.modal.incremental() ? origin[i] + value : value;
    }
  }
  store_position(parameters, first, origin);
  if (system == state.modal.system) change_offsets(state, system_offsets(context, system));
  return true;
}

void store_shift(Context& context, const Position& shift, bool applies) {
  store_position(context.parameters, kG92Offset, shift);
  context.parameters.set_numbered(kG92Applied, applies ? 1.0 : 0.0);
  Offsets offsets = context.state.offsets;
  offsets.shift = applies ? shift : Position{};
  change_offsets(context.state, offsets);
}

}  // namespace

void change_offsets(State& state, const Offsets& offsets) {
  const Position machine = to_machine(state.offsets, state.position);
  state.offsets = offsets;
  state.position = to_work(offsets, machine);
}

Offsets system_offsets(const Context& context, int system) {
  Offsets offsets = context.state.offsets;
  const int first = first_parameter(system);
  offsets.origin = load_position(context.parameters, first);
  offsets.rotation = context.parameters.numbered(first + kRotationWithinSystem);
  return offsets;
}

void activate_system(Context& context, int system) {
  context.parameters.set_numbered(kActiveSystem, system);
  context.state.modal.system = system;
  change_offsets(context.state, system_offsets(context, system));
}

bool set_system(Context& context, const Block& block) {
  const Code code = block.code(GGroup::system);
  if (!refuse_with_compensation(context, block, "a change of the coordinate system")) return false;
  if (code == 541) {
    const auto further = block.has('p') ? whole_number(block.of('p'), 1, kFurtherSystems) : std::nullopt;
    if (!further) {
      return context.faults.fail("system-number", "G54.1 without the number of a coordinate system", "give P1 to P300",
                                 block.column_of(GGroup::system));
    }
    activate_system(context, kSystemCount + *further);
    return true;
  }
  if (code >= 1100) {  // G110 to G129 of Haas are G154 P1 to P20
    activate_system(context, kSystemCount + (code - 1090) / 10);
    return true;
  }
  activate_system(context, code <= 590 ? (code - 530) / 10 : 6 + (code - 590));
  return true;
}

bool run_g10(Context& context, const Block& block) {
  const double l = block.of('l', context.rules.incremental_g10 ? 2.0 : -1.0);
  const int form = whole_number(l, 0, 100).value_or(-1);
  const bool tool_offset = !block.has('l') && (context.rules.lathe_words || !block.has_any(kLinearBits | kRotaryBits));
  if ((form == 2 || form == 20) && !(context.rules.incremental_g10 && tool_offset)) {
    return refuse_with_compensation(context, block, "G10") &&
           set_system_origin(context, block, form == 20 && !context.rules.incremental_g10);
  }
  if (context.rules.incremental_g10 && form >= 10 && form <= 13) return write_tool_offset(context, block, form);
  if (form == 1 || form == 10 || form == 11) return write_tool_entry(context, block, form);
  if (!context.rules.refuses_doubtful) {
    context.faults.warn("g10-ignored",
                        block.has('l') ? fmt::format("G10 L{:g} is not followed", l)
                                       : "G10 without L sets a tool's offset, which is not followed",
                        "", block.column_of(GGroup::once));
    return true;
  }
  return context.faults.fail("g10-form", "G10 needs L1, L2, L10, L11 or L20", "check the L word",
                             block.column_of(GGroup::once));
}

bool run_g92(Context& context, const Block& block, Code code) {
  State& state = context.state;
  if (!refuse_with_compensation(context, block, "a change of coordinates")) return false;
  if (code == 921) {
    store_shift(context, Position{}, false);
  } else if (code == 922) {
    Offsets offsets = state.offsets;
    offsets.shift = Position{};
    context.parameters.set_numbered(kG92Applied, 0.0);
    change_offsets(state, offsets);
  } else if (code == 923) {
    store_shift(context, load_position(context.parameters, kG92Offset), true);
  } else {
    Position shift = state.offsets.shift;
    if (code == kLatheOrigin) {  // G50 U W: where the tool stands reads so much more
      Position read = state.position;
      if (!add_increments(context, block, read)) return false;
      for (std::size_t i = 0; i < kAxisCount; ++i) shift[i] += state.position[i] - read[i];
    }
    for (std::size_t i = 0; i < kAxisCount; ++i) {
      if (!block.has(kAxisLetters[i])) continue;
      const double value = word_value(state, block, i);
      shift[i] = code == 520 ? value : shift[i] + (state.position[i] - value) * state.offsets.scaling.factor[i];
    }
    store_shift(context, shift, true);
  }
  return true;
}

bool set_turned_plane(Context& context, const Block& block) {
  State& state = context.state;
  Offsets offsets = state.offsets;
  const Offsets plain = system_offsets(context, state.modal.system);
  offsets.rotation = plain.rotation;
  offsets.origin = plain.origin;
  if (block.code(GGroup::turn_plane) == 680) {
    if (state.modal.plane != 170) {
      return context.faults.fail("rotation-plane", "G68 outside the XY plane", "use G17",
                                 block.column_of(GGroup::turn_plane));
    }
    // About (X, Y): origin + R₀·(p + shift) turned about the centre's machine place.
    Position centre = state.position;
    if (block.has('x')) centre[0] = word_value(state, block, 0);
    if (block.has('y')) centre[1] = word_value(state, block, 1);
    const Position fixed = to_machine(plain, centre);
    offsets.rotation += block.of('r', 0.0);
    const Position moved = to_machine(offsets, centre);
    offsets.origin[0] += fixed[0] - moved[0];
    offsets.origin[1] += fixed[1] - moved[1];
  }
  change_offsets(state, offsets);
  return true;
}

void adopt_parameters(Context& context) {
  const double active = context.parameters.numbered(kActiveSystem);
  const int system = active >= 1.0 && active <= kSystemCount ? static_cast<int>(active) : 1;
  if (context.parameters.numbered(kG92Applied) != 0.0) {
    context.state.offsets.shift = load_position(context.parameters, kG92Offset);
  }
  activate_system(context, system);
  context.state.position = to_work(context.state.offsets, Position{});  // the machine stands at its zero
}

void set_work_offsets(Context& context, const std::vector<WorkOffset>& offsets) {
  for (const WorkOffset& offset : offsets)
    store_position(context.parameters, first_parameter(offset.system), offset.origin);
}

}  // namespace toolpace::nc

namespace toolpace {

std::optional<int> work_system_named(std::string_view name) {
  static constexpr std::string_view kNames[] = {"G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"};
  std::string folded(name);
  for (char& c : folded) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 32 : c);
  for (std::size_t i = 0; i < std::size(kNames); ++i) {
    if (folded == kNames[i]) return static_cast<int>(i) + 1;
  }
  constexpr std::string_view kFurther = "G54.1P";
  if (folded.rfind(kFurther, 0) != 0) return std::nullopt;
  int number = 0;
  const char* const end = folded.data() + folded.size();
  const auto read = std::from_chars(folded.data() + kFurther.size(), end, number);
  if (read.ec != std::errc() || read.ptr != end || number < 1 || number > nc::kFurtherSystems) return std::nullopt;
  return nc::kSystemCount + number;
}

}  // namespace toolpace
