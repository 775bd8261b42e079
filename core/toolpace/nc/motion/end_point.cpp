#include "toolpace/nc/motion/end_point.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace toolpace::nc {
namespace {

constexpr double kParallel = 1e-9;  // of a line's direction
constexpr std::array<char, kAxisCount> kIncrementLetters = {'u', 'v', 'w', '\0', '\0', 'h'};

bool resolve_polar(Context& context, const Block& block, const Position& from, Position& end) {
  const State& state = context.state;
  const std::size_t column = block.column[block.has_any(1u << kRadiusWord) ? kRadiusWord : kAngleWord];
  if (state.modal.plane != 170) {
    return context.faults.fail("polar-plane", "polar words outside the XY plane", "use G17, or give X Y Z", column);
  }
  if (block.has_any(word_bit('x') | word_bit('y'))) {
    return context.faults.fail("polar-with-axis-words", "X or Y stands beside polar words", "use @ ^ or X Y, not both",
                               column);
  }
  const bool has_radius = block.has_any(1u << kRadiusWord);
  const bool has_angle = block.has_any(1u << kAngleWord);
  const double old_radius = std::hypot(from[0], from[1]);
  if (!has_angle && old_radius == 0.0) {
    return context.faults.fail("polar-angle-unknown", "the angle is unknown at the origin", "give the angle with ^",
                               block.column[kRadiusWord]);
  }
  const double old_angle = std::atan2(from[1], from[0]) / kRadiansPerDegree;
  double radius = has_radius ? block.value[kRadiusWord] * state.modal.unit() : old_radius;
  double angle = has_angle ? block.value[kAngleWord] : old_angle;
  if (state.modal.incremental()) {
    radius = old_radius + (has_radius ? radius : 0.0);
    angle = old_angle + (has_angle ? angle : 0.0);
    if (!has_radius) radius = old_radius;
    if (!has_angle) angle = old_angle;
  }
  end[0] = radius * std::cos(angle * kRadiansPerDegree);
  end[1] = radius * std::sin(angle * kRadiansPerDegree);
  return true;
}

double axis_value(const State& state, const Block& block, std::size_t axis) {
  const char letter = kAxisLetters[axis];
  if (is_rotary(axis)) return block.of(letter);
  const double value = block.of(letter) * state.modal.unit();
  return axis == 0 && state.modal.lathe_diameter == 70 ? value / 2.0 : value;
}

// G16: the plane's first axis word is a radius about the origin, its second one an angle; the others are what they are.
bool find_polar_end(Context& context, const Block& block, const Position& from, Position& end) {
  const State& state = context.state;
  const PlaneAxes plane = plane_axes(state.modal.plane);
  const bool has_radius = block.has(kAxisLetters[plane.first]), has_angle = block.has(kAxisLetters[plane.second]);
  const bool incremental = state.modal.incremental();
  end = from;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    if (i == plane.first || i == plane.second || !block.has(kAxisLetters[i])) continue;
    end[i] = axis_value(state, block, i) + (incremental ? from[i] : 0.0);
  }
  if (!has_radius && !has_angle) return true;
  if (incremental && has_radius) {
    return context.faults.fail("polar-incremental", "a radius under G16 and G91", "use G90, or leave the radius out",
                               block.column_of(kAxisLetters[plane.first]));
  }
  const double radius =
      has_radius ? axis_value(state, block, plane.first) : std::hypot(from[plane.first], from[plane.second]);
  const double here = std::atan2(from[plane.second], from[plane.first]) / kRadiansPerDegree;
  const double angle = !has_angle ? here : block.of(kAxisLetters[plane.second]) + (incremental ? here : 0.0);
  end[plane.first] = radius * std::cos(angle * kRadiansPerDegree);
  end[plane.second] = radius * std::sin(angle * kRadiansPerDegree);
  return true;
}

bool find_machine_end(Context& context, const Block& block, Position& end) {
  const State& state = context.state;
  if (state.modal.incremental() && !context.rules.machine_moves_incremental) {
    return context.faults.fail("g53-incremental", "G53 under G91", "use G90 with G53", block.column_of(GGroup::once));
  }
  if (block.has_any(kPolarBits)) {
    return context.faults.fail("g53-polar", "G53 with polar words", "give X and Y", block.column_of(GGroup::once));
  }
  Position machine = to_machine(state.offsets, state.position);
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    if (block.has(kAxisLetters[i])) machine[i] = axis_value(state, block, i);
  }
  end = to_work(state.offsets, machine);
  return true;
}

}  // namespace

bool add_increments(Context& context, const Block& block, Position& end) {
  const State& state = context.state;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    const char letter = kIncrementLetters[i];
    if (letter == '\0' || !block.has(letter)) continue;
    if (block.has(kAxisLetters[i])) {
      const char shown = static_cast<char>(letter - 32), axis = static_cast<char>(kAxisLetters[i] - 32);
      return context.faults.fail("increment-twice", fmt::format("both {} and {} in a block", axis, shown),
                                 "give one of them", block.column_of(letter));
    }
    const double value = is_rotary(i) ? block.of(letter) : block.of(letter) * state.modal.unit();
    end[i] += i == 0 && state.modal.lathe_diameter == 70 ? value / 2.0 : value;
  }
  return true;
}

const Position& programmed_position(const State& state) {
  if (state.waiting) return state.waiting->end;
  const Compensation& compensation = state.compensation;
  return compensation.radius > 0.0 && !compensation.first_move_pending ? compensation.programmed : state.position;
}

bool names_axis(const Context& context, const Block& block, std::size_t axis) {
  const char increment = kIncrementLetters[axis];
  return block.has(kAxisLetters[axis]) || (context.rules.lathe_words && increment != '\0' && block.has(increment));
}

double length_of(const State& state, const Block& block, char letter) { return block.of(letter) * state.modal.unit(); }

bool find_end_on_line(Context& context, const Block& block, const Position& from, Position& end) {
  const PlaneAxes plane = plane_axes(context.state.modal.plane);
  const bool has_first = names_axis(context, block, plane.first), has_second = names_axis(context, block, plane.second);
  if (has_first == has_second) return true;  // both are given, or the next block tells
  const double angle = block.value[kLineAngleWord] * kRadiansPerDegree;
  const std::size_t given = has_first ? plane.first : plane.second, other = has_first ? plane.second : plane.first;
  const double along = has_first ? std::cos(angle) : std::sin(angle);
  const double across = has_first ? std::sin(angle) : std::cos(angle);
  if (std::fabs(along) < kParallel) {
    return context.faults.fail(
        "line-angle",
        fmt::format("a line at {:g} degrees never reaches its end in {}", block.value[kLineAngleWord],
                    static_cast<char>(kAxisLetters[given] - 32)),
        "check the angle, which counts from the first axis of the plane: Z of lathes, X of mills",
        block.column[kLineAngleWord]);
  }
  end[other] = from[other] + (end[given] - from[given]) * across / along;
  return true;
}

bool find_end(Context& context, const Block& block, Position& end) {
  const State& state = context.state;
  if (block.code(GGroup::once) == 530) return find_machine_end(context, block, end);
  const Position& from = programmed_position(state);
  end = from;
  const bool incremental = state.modal.incremental();
  if (state.modal.polar) return find_polar_end(context, block, from, end);
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    if (!block.has(kAxisLetters[i])) continue;
    const double value = axis_value(state, block, i);
    end[i] = incremental ? from[i] + value : value;
  }
  if (context.rules.lathe_words && !add_increments(context, block, end)) return false;
  if (!block.has_any(kPolarBits | kLineAngleBit)) return true;
  return block.has_any(kPolarBits) ? resolve_polar(context, block, from, end)
                                   : find_end_on_line(context, block, from, end);
}

}  // namespace toolpace::nc
