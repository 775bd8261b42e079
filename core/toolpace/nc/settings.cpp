#include "toolpace/nc/settings.h"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include "toolpace/nc/coordinates.h"
#include "toolpace/nc/motion/compensation.h"
#include "toolpace/nc/motion/motion.h"
#include "toolpace/nc/program_limits.h"
#include "toolpace/nc/scaling.h"
#include "toolpace/nc/text/whole_number.h"
#include "toolpace/nc/tool_table.h"

namespace toolpace::nc {
namespace {

constexpr double kHighestFeed = 1e9;  // [units/min]
constexpr int kHighestSpindle = 7;
constexpr int kRoughToFinish = 3, kFastestToFinest = 10;  // levels of G187 P and of G5.1 R

bool set_plane(Context& context, const Block& block) {
  const Code code = block.code(GGroup::plane);
  if (context.state.modal.compensation != 400 && code != context.state.modal.plane &&
      (context.rules.refuses_doubtful || context.state.compensation.radius > 0.0)) {
    return context.faults.fail("plane-with-compensation", "a change of plane while cutter radius compensation is on",
                               "end it with G40 first", block.column_of(GGroup::plane));
  }
  context.state.modal.plane = code;
  return true;
}

bool set_units(Context& context, const Block& block) {
  context.state.modal.units = block.code(GGroup::units);
  context.state.units_given = true;
  return true;
}

/// A level from the fastest one to the most accurate one, as a share of the way.
bool set_level(Context& context, const Block& block, char letter, int most) {
  if (!block.has(letter)) {
    set_accuracy(context, 0.0);
    return true;
  }
  const auto level = whole_number(block.of(letter), 1, most);
  if (!level) {
    return context.faults.fail("accuracy-level", fmt::format("there is no level {:g}", block.of(letter)),
                               fmt::format("levels go from 1 to {}", most), block.column_of(letter));
  }
  set_accuracy(context, (*level - 1.0) / (most - 1.0));
  return true;
}

// G187 of Haas: E is how far corners may be rounded, P goes from rough over medium to finish.
bool set_smoothness(Context& context, const Block& block) {
  Modal& modal = context.state.modal;
  modal.tolerance_given = block.has('e') && block.of('e') > 0.0;
  modal.path_tolerance = modal.tolerance_given ? length_of(context.state, block, 'e') : 0.0;
  modal.naive_tolerance = 0.0;
  return set_level(context, block, 'p', kRoughToFinish);
}

// G5.1 of Fanuc: Q1 looks ahead, R goes from the fastest level to the most accurate one; Q0 ends it.
bool set_contour_control(Context& context, const Block& block) {
  if (block.of('q', 1.0) != 0.0) return set_level(context, block, 'r', kFastestToFinest);
  set_accuracy(context, 0.0);
  return true;
}

bool set_path_control(Context& context, const Block& block) {
  Modal& modal = context.state.modal;
  if (block.code(GGroup::path_control) == kSmoothness) return set_smoothness(context, block);
  if (block.code(GGroup::path_control) == kContourControl) return set_contour_control(context, block);
  modal.path_control = block.code(GGroup::path_control);
  if (modal.path_control != 640) return true;
  const bool has_p = block.has('p');
  modal.tolerance_given = has_p;
  modal.path_tolerance = has_p ? length_of(context.state, block, 'p') : 0.0;
  modal.naive_tolerance = block.has('q') ? length_of(context.state, block, 'q') : modal.path_tolerance;
  if (modal.path_tolerance < 0.0 || modal.naive_tolerance < 0.0) {
    context.faults.warn("tolerance-negative", "a tolerance below 0 counts as none", "P and Q of G64 are not below 0",
                        block.column_of(GGroup::path_control));
    modal.tolerance_given = false;
    modal.path_tolerance = modal.naive_tolerance = 0.0;
  }
  return true;
}

}  // namespace

bool set_feed_mode(Context& context, const Block& block) {
  Modal& modal = context.state.modal;
  const Code code = block.code(GGroup::feed_mode);
  if (modal.feed_mode != code) modal.feed = modal.feed_linear = 0.0;  // F has another meaning now
  modal.feed_mode = code;
  context.state.feed_mode_doubtful = false;
  return true;
}

namespace {

// No lathe feeds so slowly: 0.2 is meant for a turn, and the G94 before for nothing, as in G-code system A.
void settle_feed_mode(Context& context, double feed, std::size_t column) {
  constexpr double kSlowestFeed = 2.0;  // [mm/min]
  State& state = context.state;
  if (!state.feed_mode_doubtful || feed * state.modal.unit() >= kSlowestFeed) return;
  state.feed_mode_doubtful = false;
  state.modal.feed_mode = 950;
  context.faults.warn("feed-a-turn", fmt::format("F{:g} after G94 alone is read as a feed a turn", feed),
                      "say G98 or G99, or choose --dialect fanuc-lathe-b for a feed a minute", column);
}

}  // namespace

bool set_feed(Context& context, const Block& block) {
  Modal& modal = context.state.modal;
  const double feed = block.of('f');
  if (feed > kHighestFeed) {
    return context.faults.fail("feed-too-large", fmt::format("a feedrate of {:g}", feed), "check the feedrate",
                               block.column_of('f'));
  }
  if (!(feed >= 0.0))
    return context.faults.fail("feed-negative", fmt::format("a feedrate of {:g}", feed), "a feedrate is not below 0",
                               block.column_of('f'));
  if (modal.feed_mode == 930) return true;  // belongs to its block alone
  settle_feed_mode(context, feed, block.column_of('f'));
  modal.feed = feed;
  modal.feed_linear = feed * modal.unit();
  return true;
}

bool exchange_spindle(Context& context, const Block& block) {
  const auto number = whole_number(block.value[kSpindleWord], -1, kHighestSpindle);
  if (!number) {
    return context.faults.fail("spindle-number", fmt::format("there is no spindle ${:g}", block.value[kSpindleWord]),
                               "spindles are $0 to $7; $-1 is all of them", block.column[kSpindleWord]);
  }
  if (*number <= 0) return true;
  Modal& modal = context.state.modal;
  OtherSpindle& other = context.state.spindles[*number];
  std::swap(modal.spindle_mode, other.mode);
  std::swap(modal.spindle_speed, other.speed);
  std::swap(modal.spindle_limit, other.limit);
  std::swap(modal.spindle_direction, other.direction);
  return true;
}

bool set_speed(Context& context, const Block& block) {
  const double speed = block.of('s');
  if (!(speed >= 0.0))
    return context.faults.fail("speed-negative", fmt::format("a spindle speed of {:g}", speed),
                               "a spindle speed is not below 0", block.column_of('s'));
  const Code once = block.code(GGroup::once);
  const bool limits = once == 920 && !context.rules.refuses_doubtful && !block.has_any(kAxisBits | kIncrementBits);
  if (once == kLatheOrigin || limits) {  // G50 S, G92 S: never faster than that
    context.state.modal.spindle_limit = speed > 0.0 ? speed : std::numeric_limits<double>::infinity();
    return true;
  }
  context.state.modal.spindle_speed = speed;
  return true;
}

bool set_spindle_mode(Context& context, const Block& block) {
  const Code code = block.code(GGroup::spindle_mode);
  if (code == 960 && !block.has('s') && context.rules.refuses_doubtful) {
    return context.faults.fail("g96-without-s", "G96 without S", "give the cutting speed with S",
                               block.column_of(GGroup::spindle_mode));
  }
  const double none = std::numeric_limits<double>::infinity();
  const double limit = block.of('d', context.rules.lathe_words ? context.state.modal.spindle_limit : none);
  if (!(limit > 0.0)) {
    return context.faults.fail("g96-limit", fmt::format("D{:g} is no highest speed of the spindle", limit),
                               "D of G96 is above 0, in turns a minute", block.column_of('d'));
  }
  context.state.modal.spindle_mode = code;
  context.state.modal.spindle_limit = limit;
  return true;
}

bool run_settings(Context& context, const Block& block) {
  Modal& modal = context.state.modal;
  if (block.has(GGroup::plane) && !set_plane(context, block)) return false;
  if (block.has(GGroup::units) && !set_units(context, block)) return false;
  if (block.has(GGroup::lathe_diameter)) modal.lathe_diameter = block.code(GGroup::lathe_diameter);
  if (block.has(GGroup::compensation) && !set_compensation(context, block)) return false;
  if (block.has(GGroup::tool_length) && !set_tool_length(context, block)) return false;
  if (block.has(GGroup::system) && !set_system(context, block)) return false;
  if (block.has(GGroup::mirror) && !set_mirror(context, block)) return false;
  if (block.has(GGroup::scale) && !set_scale(context, block)) return false;
  if (block.has(GGroup::turn_plane) && !set_turned_plane(context, block)) return false;
  if (block.has(GGroup::polar)) modal.polar = block.code(GGroup::polar) == 160;
  if (block.has(GGroup::path_control) && !set_path_control(context, block)) return false;
  if (block.has(GGroup::distance)) modal.distance = block.code(GGroup::distance);
  if (block.has(GGroup::arc_distance)) modal.arc_distance = block.code(GGroup::arc_distance);
  if (block.has(GGroup::retract)) modal.retract = block.code(GGroup::retract);
  return true;
}

void restore_modal(Context& context, const Modal& saved) {
  Modal& modal = context.state.modal;
  const Code motion = modal.motion;
  const int system = saved.system;
  const bool other_system = modal.system != system;
  const Code compensation = modal.compensation;
  modal = saved;
  modal.motion = motion;
  modal.compensation = compensation;
  if (other_system) activate_system(context, system);
}

}  // namespace toolpace::nc
