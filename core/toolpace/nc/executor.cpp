#include "toolpace/nc/executor.h"

#include <fmt/format.h>

#include <cmath>

#include "toolpace/nc/block_words.h"
#include "toolpace/nc/coordinates.h"
#include "toolpace/nc/dwell.h"
#include "toolpace/nc/macro_arithmetic.h"
#include "toolpace/nc/motion/corners.h"
#include "toolpace/nc/motion/motion.h"
#include "toolpace/nc/once_codes.h"
#include "toolpace/nc/program_limits.h"
#include "toolpace/nc/settings.h"
#include "toolpace/nc/text/whole_number.h"
#include "toolpace/nc/tool_table.h"

namespace toolpace::nc {
namespace {

constexpr Code kHeidenhainTip = 128;
constexpr std::uint32_t kMotionGroup = 1u << static_cast<unsigned>(GGroup::motion);
constexpr std::uint32_t kPlainWords = kLinearBits | kRotaryBits | word_bit('f');

// Whether the block is a move that a corner leads to, and changes nothing that the corner depends on.
bool goes_on_from_corner(const Block& block, Code motion) {
  constexpr auto bit = [](GGroup group) { return 1u << static_cast<unsigned>(group); };
  constexpr std::uint32_t kBreaks = bit(GGroup::once) | bit(GGroup::plane) | bit(GGroup::units) |
                                    bit(GGroup::compensation) | bit(GGroup::system) | bit(GGroup::macro) |
                                    bit(GGroup::tool_length) | bit(GGroup::turn_plane) | bit(GGroup::feed_mode);
  return (motion == 10 || motion == 20 || motion == 30) && (block.g_groups & kBreaks) == 0;
}

}  // namespace

bool Executor::run(const Block& block) {
  if (!block.has_any(1u << kSpindleWord)) return run_in_order(block);
  if (!exchange_spindle(context_, block)) return false;
  const bool good = run_in_order(block);
  return exchange_spindle(context_, block) && good;
}

bool Executor::run_in_order(const Block& block) {
  if (block.g_groups == 0 && block.m_groups == 0 && block.words == 0) {
    return block.message.empty() || raise_alarm(context_, block);
  }
  Code motion = kNoCode;
  if (!find_motion(context_, block, motion) || !check_words(context_, block, motion)) return false;
  const bool plain = (block.g_groups & ~kMotionGroup) == 0 && block.m_groups == 0 && (block.words & ~kPlainWords) == 0;
  if (context_.state.waiting && !goes_on_from_corner(block, motion) && !release_corner(context_)) return false;
  if (!plain) {
    if (block.has(GGroup::feed_mode) && !set_feed_mode(context_, block)) return false;
    if (block.has(GGroup::spindle_mode) && !set_spindle_mode(context_, block)) return false;
  }
  if (block.has('f') && !set_feed(context_, block)) return false;
  if (!plain) {
    const bool sets_limits = block.has(MGroup::limits);  // M204 S T are accelerations
    if (block.has('s') && !sets_limits && !set_speed(context_, block)) return false;
    if (block.has('t') && !sets_limits && !select_tool(context_, block)) return false;
    if (block.m_groups != 0 && !run_machine_codes(block)) return false;
    if (!run_dwell(block) || !run_settings(context_, block)) return false;
    context_.out.set_travelling(!block.has('e'));
    context_.out.set_mode(context_.state.modal);
    if (block.has(GGroup::once) && !run_once_code(context_, block)) return false;
    if (block.has(GGroup::macro) || !block.message.empty()) {
      if (!raise_alarm(context_, block)) return false;
    }
  }
  if (plain && context_.state.limits.has_own_travels()) {
    context_.out.set_travelling(true);
    context_.out.set_mode(context_.state.modal);
  }
  if (motion != kNoCode) {
    if (!is_cycle(motion)) context_.state.cycle.initial_level.reset();
    if (!run_any_motion(block, motion)) return false;
  }
  if (plain) return !macros_.has_modal() || macros_.run(block);
  if (is_macro_arithmetic(block)) return run_macro_arithmetic(context_, flow_, block);
  return macros_.run(block) && run_stop(block);
}

bool Executor::run_any_motion(const Block& block, Code motion) {
  if (is_lathe_cycle(motion)) return contours_.turn(block, motion);
  if (motion >= kLatheFinish && motion <= kLatheRepeat) return contours_.turn_lines(block, motion);
  return run_motion(context_, block, motion);
}

bool Executor::run_machine_codes(const Block& block) {
  if (block.has(MGroup::tool) && !change_tool(context_, block)) return false;
  if (block.has(MGroup::spindle)) {
    const Code code = block.code(MGroup::spindle);
    context_.state.modal.spindle_direction = code == 3 ? 1 : code == 4 ? -1 : 0;
  }
  if (block.has(MGroup::override_)) set_overrides(context_, block);
  if (block.has(MGroup::limits)) set_program_limits(context_, block);
  if (block.has(MGroup::state) && !run_saved_state(block.code(MGroup::state))) return false;
  if (block.has(MGroup::coolant)) {
    const Code code = block.code(MGroup::coolant);
    context_.state.modal.mist = code == 7 || (code == 8 && context_.state.modal.mist);
    context_.state.modal.flood = code == 8 || (code == 7 && context_.state.modal.flood);
  }
  if (block.has(MGroup::ignored) && block.code(MGroup::ignored) == kHeidenhainTip && !context_.state.tip_code)
    context_.state.tip_code = CodePlace{flow_.line_number(), context_.out.size()};
  if (block.has(MGroup::user)) {
    context_.faults.warn(
        "m-code-user",
        fmt::format("M{} is defined by the machine; it is taken to move nothing", block.code(MGroup::user)), "",
        block.column_of(MGroup::user));
  }
  return true;
}

bool Executor::run_saved_state(Code code) {
  auto& saved = flow_.saved_modal();
  if (code == 70 || code == 73) {
    saved = SavedModal{context_.state.modal, code == 73};
  } else if (code == 71) {
    saved.reset();
  } else {
    if (!saved)
      return context_.faults.fail("state-not-saved", "M72 without a saved state",
                                  "save it with M70 in the same program or sub-program");
    restore_modal(context_, saved->modal);
  }
  return true;
}

bool Executor::run_dwell(const Block& block) {
  if (block.code(GGroup::once) != 40) return true;
  const std::size_t column = block.column_of(GGroup::once);
  double seconds = 0.0;
  if (block.has('p')) {
    seconds = dwell_of(context_, block);
  } else if (context_.rules.dwells_by_axis_words && block.has_any(word_bit('x') | word_bit('u') | word_bit('s'))) {
    seconds = block.of(block.has('x') ? 'x' : block.has('u') ? 'u' : 's');
  } else if (context_.rules.refuses_doubtful) {
    return context_.faults.fail("dwell-without-time", "G4 without a time", "give it with P", column);
  } else {
    context_.faults.warn("dwell-without-time", "G4 without a time", "give it with P", column);
    return true;
  }
  if (!is_dwell(seconds)) {
    return context_.faults.fail("dwell-negative", fmt::format("a dwell of {:g} s", seconds),
                                "give a time of 0 to 1e9 s", column);
  }
  context_.out.set_mode(context_.state.modal);
  context_.out.dwell(seconds);
  return true;
}

bool Executor::run_stop(const Block& block) {
  if (block.has(MGroup::stop)) {
    const Code code = block.code(MGroup::stop);
    const bool ends = code == 2 || code == 30;
    context_.out.note(ends ? MoveKind::end : MoveKind::stop, fmt::format("M{}", code));
    if (ends) ended_ = true;
  }
  return !block.has(MGroup::subprogram) || run_subprogram_code(block);
}

// M98 P2 Q10: from N10 of O2 on.
bool Executor::begin_at(const Block& block, int times) {
  const std::size_t column = block.column_of('q');
  if (times > 1) {
    return context_.faults.fail("call-repeats", "a call that begins at a line of its own is not repeated here",
                                "repeat the whole sub-program, or call it several times", column);
  }
  return times == 0 || flow_.go_to_number(block.of('q'), column);
}

bool Executor::run_subprogram_code(const Block& block) {
  const std::size_t column = block.column_of(MGroup::subprogram);
  if (block.code(MGroup::subprogram) == 99) {
    const auto to = block.has('p') ? std::optional(block.of('p')) : std::nullopt;
    if (flow_.return_from_call(to)) {
      if (const auto modal = flow_.take_restored()) restore_modal(context_, *modal);
      return true;
    }
    if (to && context_.rules.macro_statements) return flow_.go_to_number(*to, block.column_of('p'));
    context_.faults.warn("program-repeats", "M99 makes the program begin again without end; it is read once",
                         "end it with M30", column);
    context_.out.note(MoveKind::end, "M99");
    ended_ = true;
    return true;
  }
  const bool calls_line = !block.has('p') && block.has('h') && context_.rules.macro_statements;  // M98 H10: as M97 P10
  if (!block.has('p') && !calls_line && block.called.empty())
    return context_.faults.fail("m98-without-p", "M98 without P", "name the sub-program with P", column);
  double number = block.of('p', 0.0);
  double repeats = block.of('l', 1.0);
  const bool may_repeat = context_.rules.repeats_within_p && !block.has('l') && number >= 10000.0;
  if (may_repeat && !flow_.has_program(label_of(number))) {  // P00021000: twice O1000
    repeats = std::floor(number / 10000.0);
    number -= repeats * 10000.0;
  }
  const auto times = whole_number(repeats, 0, kMostCalls);
  if (!times)
    return context_.faults.fail("call-repeats", fmt::format("{:g} repeats of a call", repeats),
                                "L is a whole number from 0 to 999999999", column);
  if (calls_line) return flow_.call_line(block.of('h'), *times, block.column_of('h'));
  if (block.code(MGroup::subprogram) == 97) return flow_.call_line(number, *times, block.column_of('p'));
  if (!block.called.empty()) return flow_.call_numbered(block.called, *times, column, std::nullopt);
  if (!flow_.call_numbered(label_of(number), *times, block.column_of('p'), std::nullopt)) return false;
  return !block.has('q') || !context_.rules.macro_statements || begin_at(block, *times);
}

}  // namespace toolpace::nc
