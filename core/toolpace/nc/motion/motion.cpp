#include "toolpace/nc/motion/motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "toolpace/nc/motion/arcs.h"
#include "toolpace/nc/motion/compensation.h"
#include "toolpace/nc/motion/corners.h"
#include "toolpace/nc/motion/cycles.h"
#include "toolpace/nc/motion/spindle.h"
#include "toolpace/nc/motion/splines.h"
#include "toolpace/nc/motion/threading.h"
#include "toolpace/nc/motion/turning.h"
#include "toolpace/nc/motion/turning_cycles.h"

namespace toolpace::nc {
namespace {

constexpr double kNoLength = 1e-12;
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

// U V W H of lathes, whatever G90 or G91 would say.
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

bool run_straight(Context& context, const Block& block, Code code) {
  const State& state = context.state;
  const bool machine_coordinates = block.code(GGroup::once) == 530;
  if (state.compensation.radius > 0.0 && machine_coordinates) {
    return context.faults.fail("g53-with-compensation", "G53 while cutter radius compensation is on",
                               "end it with G40 first", block.column_of(GGroup::once));
  }
  Position end;
  if (!find_end(context, block, end)) return false;
  if (code == 10 && meets_corner(context, block)) return run_cornered_line(context, block, code, end);
  return go_straight(context, block, code, end);
}

bool run_probe(Context& context, const Block& block, Code code) {
  State& state = context.state;
  const std::size_t column = block.column_of(GGroup::motion);
  if (state.compensation.radius > 0.0) {
    return context.faults.fail("probe-with-compensation", "probing while cutter radius compensation is on",
                               "end it with G40 first", column);
  }
  if (state.modal.feed_mode == 930) {
    return context.faults.fail("probe-inverse-time", "probing in inverse-time mode", "use G94", column);
  }
  if (state.modal.feed == 0.0)
    return context.faults.fail("no-feed", "probing without a feedrate", "give F before", column);
  Position end;
  Feedrate feed;
  if (!find_end(context, block, end)) return false;
  const bool moves = !std::equal(end.begin(), end.end(), state.position.begin(),
                                 [](double a, double b) { return std::fabs(a - b) < 1e-6; });
  if (!moves && (code == 382 || code == 384)) {
    return context.faults.fail("probe-goes-nowhere", fmt::format("{} ends where it begins", code_text('G', code)),
                               "give an end point away from here", column);
  }
  if (!find_straight_feedrate(context, block, state.position, end, feed)) return false;
  context.out.line(MoveKind::probe, state.offsets, end, feed);
  state.position = end;
  // In the units of the program at this moment, as LinuxCNC keeps them.
  Position result = end;
  for (std::size_t i = 0; i < kAxisCount; ++i) result[i] /= is_rotary(i) ? 1.0 : state.modal.unit();
  store_position(context.parameters, kProbedPosition, result);
  return true;
}

}  // namespace

void store_position(Parameters& parameters, int first, const Position& position) {
  for (std::size_t i = 0; i < kAxisCount; ++i) parameters.set_numbered(first + static_cast<int>(i), position[i]);
}

Position load_position(const Parameters& parameters, int first) {
  Position position;
  for (std::size_t i = 0; i < kAxisCount; ++i) position[i] = parameters.numbered(first + static_cast<int>(i));
  return position;
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
  return !block.has_any(kPolarBits) || resolve_polar(context, block, from, end);
}

bool find_feedrate(Context& context, const Block& block, const Way& way, Feedrate& feed) {
  const double linear_length = way.linear, angular_length = way.angular;
  const Modal& modal = context.state.modal;
  if (modal.feed_mode == 930) {
    if (!block.has('f')) {
      return context.faults.fail("inverse-time-without-feed",
                                 "a feed move in inverse-time mode (G93) without an F word",
                                 "give F in every block with a feed move, or use G94");
    }
    feed.linear = linear_length * block.of('f');
    feed.angular = angular_length * block.of('f');
    if (block.of('f') > 0.0) return true;
    return context.faults.fail("no-feed", "a feed of zero", "give a positive F", block.column_of('f'));
  }
  if (modal.feed == 0.0)
    return context.faults.fail("no-feed", "a feed move without a feedrate", "give F before or in this block");
  double turns = 1.0;
  if (modal.feed_mode == 950) {
    turns = spindle_turns(context.state, way.from, way.to);
    if (turns == 0.0) {
      return context.faults.fail("spindle-stopped", "feed per turn (G95) without a spindle speed", "give S before");
    }
    if (std::isinf(turns)) {
      return context.faults.fail("spindle-unbounded",
                                 "at X0 constant surface speed (G96) turns the spindle without bound",
                                 "give the highest speed with D beside G96");
    }
  }
  feed.linear = modal.feed_linear * turns;
  feed.angular = modal.feed * turns;
  return true;
}

bool find_straight_feedrate(Context& context, const Block& block, const Position& from, const Position& to,
                            Feedrate& feed) {
  double linear = 0.0, angular = 0.0;
  if (context.state.modal.feed_mode == 930) {  // lengths matter in inverse-time mode alone
    for (std::size_t i = 0; i < kAxisCount; ++i)
      (is_rotary(i) ? angular : linear) += (to[i] - from[i]) * (to[i] - from[i]);
    linear = std::sqrt(linear);
    angular = std::sqrt(angular);
    if (linear < kNoLength) linear = 0.0;
  }
  return find_feedrate(context, block, {linear, angular, from[0], to[0]}, feed);
}

bool go_straight(Context& context, const Block& block, Code code, const Position& end) {
  State& state = context.state;
  Feedrate feed;
  const Position& from = programmed_position(state);
  if (code == 10 && !find_straight_feedrate(context, block, from, end, feed)) return false;
  const MoveKind kind = code == 0 ? MoveKind::rapid : MoveKind::feed;
  if (state.modal.compensation != 400 && state.compensation.radius > 0.0) {
    return compensate_line(context, kind, end, feed);
  }
  context.out.line(kind, state.offsets, end, feed);
  state.position = end;
  state.compensation.arc_forbidden = false;
  return true;
}

bool run_motion(Context& context, const Block& block, Code code) {
  if (code == 0 || code == 10 || code == 20 || code == 30) context.state.plain_motion = code;
  // On Fanuc controllers G80 ends cycles alone; the motion code before them goes on.
  context.state.modal.motion = code == 800 && context.rules.g80_keeps_motion ? context.state.plain_motion : code;
  if (code < kForeignCodes) context.state.turning.code = kNoCode;
  if (code != 50) context.state.spline.after_cubic = false;
  if (context.state.spline.collecting && code != 52 && code != 53) {
    context.faults.warn("spline-not-closed", "another motion before G5.3 gives the spline up",
                        "end the spline with G5.3", block.column_of(GGroup::motion));
    context.state.spline.collecting = false;
  }
  switch (code) {
    case 0:
    case 10: return run_straight(context, block, code);
    case 20:
    case 30: return run_arc(context, block, code);
    case 50: return run_cubic_spline(context, block);
    case 51: return run_quadratic_spline(context, block);
    case 52: return collect_nurbs(context, block);
    case 53: return finish_nurbs(context, block);
    case 330: return run_synchronised(context, block);
    case 331: return run_rigid_tap(context, block);
    case 382:
    case 383:
    case 384:
    case 385: return run_probe(context, block, code);
    case 760: return run_threading(context, block);
    case 800: return true;
    case kLatheThread: return run_lathe_thread(context, block);
    case kLatheFaceGroove:
    case kLatheGroove: return run_grooving(context, block, code);
    case kLatheThreads: return run_threads(context, block);
    case kLatheTurning:
    case kLatheFacing:
    case kLatheThreading: return run_turning(context, block, code);
    default: return run_cycle(context, block, code);
  }
}

}  // namespace toolpace::nc
