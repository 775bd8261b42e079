#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "toolpace/nc/coordinates.h"
#include "toolpace/nc/dwell.h"
#include "toolpace/nc/interpreter.h"
#include "toolpace/nc/motion/compensation.h"
#include "toolpace/nc/motion/lathe_cycles.h"
#include "toolpace/nc/motion/motion.h"
#include "toolpace/nc/text/whole_number.h"
#include "toolpace/nc/tool_table.h"

namespace toolpace::nc {
namespace {

constexpr bool is_cycle(Code code) { return (code >= 730 && code <= 760) || (code >= 810 && code <= 890); }

// Codes outside the motion group that take the block's axis words for themselves.
constexpr bool takes_axes(Code code) { return code == 100 || code == 280 || code == 300 || code == 520 || code == 920; }

constexpr std::uint32_t bit(GGroup group) { return 1u << static_cast<unsigned>(group); }
constexpr std::uint32_t kMotionGroup = bit(GGroup::motion);
constexpr std::uint32_t kPlainWords = kLinearBits | kRotaryBits | word_bit('f');

std::uint32_t words_of_motion(Code motion) {
  switch (motion) {
    case 20:
    case 30: return kCentreBits | word_bit('r') | word_bit('p');
    case 50: return word_bit('i') | word_bit('j') | word_bit('p') | word_bit('q');
    case 51: return word_bit('i') | word_bit('j');
    case 52: return word_bit('p') | word_bit('l');
    case 330:
    case 331: return word_bit('k') | word_bit('i');
    case 760:
      return kCentreBits | word_bit('p') | word_bit('q') | word_bit('r') | word_bit('h') | word_bit('e') |
             word_bit('l');
    case 700: return word_bit('q') | word_bit('d') | word_bit('e') | word_bit('p');
    case 710:
    case 711:
    case 712:
    case 720:
    case 721:
    case 722: return word_bit('q') | word_bit('d') | word_bit('i') | word_bit('r') | word_bit('u') | word_bit('w');
    case 740: return word_bit('r') | word_bit('p') | word_bit('q') | kCentreBits;  // LinuxCNC does not repeat it by L
    default: return is_cycle(motion) ? word_bit('r') | word_bit('l') | word_bit('p') | word_bit('q') | kCentreBits : 0;
  }
}

std::uint32_t words_of_settings(const Block& block) {
  std::uint32_t words = 0;
  const Code once = block.code(GGroup::once);
  if (once == 40) words |= word_bit('p');
  if (once == 100) words |= word_bit('l') | word_bit('p') | word_bit('r') | word_bit('q') | kCentreBits;
  if (block.has(GGroup::compensation)) words |= word_bit('d') | word_bit('l');
  if (block.has(GGroup::tool_length)) words |= word_bit('h');
  if (block.has(GGroup::path_control)) words |= word_bit('p') | word_bit('q');
  if (block.has(GGroup::spindle_mode)) words |= word_bit('d');
  if (block.has(GGroup::macro)) words |= ~0u;
  if (block.has(GGroup::turn_plane)) words |= word_bit('r') | kCentreBits;
  if (block.has(MGroup::tool)) words |= word_bit('q');
  if (block.has(MGroup::io)) words |= word_bit('p') | word_bit('q') | word_bit('e') | word_bit('l');
  if (block.has(MGroup::override_) || block.has(MGroup::user)) words |= word_bit('p') | word_bit('q');
  if (block.has(MGroup::spindle)) words |= word_bit('r') | word_bit('q') | word_bit('p');
  if (block.has(MGroup::subprogram)) words |= word_bit('p') | word_bit('l') | word_bit('q');
  if (block.has(MGroup::ignored) || block.has(GGroup::ignored)) words |= ~0u;
  return words;
}

}  // namespace

bool Interpreter::find_motion(const Block& block, Code& motion) {
  const bool axes = block.has_any(kAxisBits);
  const Code once = block.code(GGroup::once);
  const Code named = block.code(GGroup::motion);
  motion = kNoCode;
  const bool claimed = takes_axes(once) || block.code(GGroup::tool_length) == 431 ||
                       block.code(GGroup::tool_length) == 432 || block.has(GGroup::macro) ||
                       block.has(GGroup::turn_plane) || (once == 40 && dialect_ != Dialect::linuxcnc) ||
                       (block.has(MGroup::ignored) && dialect_ == Dialect::grbl);  // M92 X80, M205 X8: settings
  if (claimed && named != kNoCode && named != 800 && takes_axes(once)) {
    return faults_.fail("two-codes-want-axes",
                        fmt::format("{} and {} both use the axis words", code_text('G', once), code_text('G', named)),
                        "put them into blocks of their own", block.column_of(GGroup::motion));
  }
  if (once == 40 && !block.has('p') && dialect_ == Dialect::linuxcnc) {
    return faults_.fail("dwell-without-time", "G4 without a time", "give it in seconds with P",
                        block.column_of(GGroup::once));
  }
  const bool extruder_alone = dialect_ == Dialect::grbl && once == 920 && block.has('e');
  if ((once == 920 || once == 520) && !axes && !extruder_alone) {
    return faults_.fail("axes-missing", fmt::format("{} without axis words", code_text('G', once)),
                        "give at least one axis", block.column_of(GGroup::once));
  }
  if (named == 800) {
    if (axes && !claimed) {
      return faults_.fail("axes-with-g80", "axis words in a block with G80", "put them into a block with a motion code",
                          block.column_of(GGroup::motion));
    }
    motion = 800;
  } else if (named != kNoCode) {
    motion = named;
  } else if (axes && !claimed) {
    if (state_.modal.motion == 800) {
      return faults_.fail("axes-without-motion", "axis words while no motion code is active",
                          "give a motion code such as G0 or G1");
    }
    motion = state_.modal.motion;
  } else if (!claimed && block.has_any(kCentreBits) && (state_.modal.motion == 20 || state_.modal.motion == 30)) {
    motion = state_.modal.motion;
  }
  return true;
}

bool Interpreter::check_words(const Block& block, Code motion) {
  constexpr std::uint32_t kAlways = kAxisBits | word_bit('f') | word_bit('s') | word_bit('t');
  std::uint32_t unused = block.words & ~kAlways;
  if (unused == 0) return true;
  unused &= ~(words_of_motion(motion) | words_of_settings(block));
  if (unused == 0) return true;
  for (std::size_t i = 0; i < 26; ++i) {
    if ((unused & (1u << i)) == 0) continue;
    if (dialect_ == Dialect::grbl && i == word_index('e')) {
      if (!std::exchange(extruder_told_, true)) {
        faults_.warn("extruder-ignored", "the extruder E is left out of the path", "", block.column[i]);
      }
      continue;
    }
    if (i == word_index('u') || i == word_index('v') || i == word_index('w')) {
      return faults_.fail("axis-absent", fmt::format("this machine has no axis {}", static_cast<char>('A' + i)),
                          "axes are X Y Z A B C", block.column[i]);
    }
    const std::string what = fmt::format("nothing in this block uses word {}", static_cast<char>('A' + i));
    if (dialect_ == Dialect::linuxcnc) {
      const char* const remedy = i == word_index('e') ? "remove it; numbers have no exponent here: write them out"
                                                      : "remove it, or add the code it belongs to";
      return faults_.fail("word-unused", what, remedy, block.column[i]);
    }
    faults_.warn("word-unused", what, "", block.column[i]);
  }
  return true;
}

bool Interpreter::execute(const Block& block) {
  if (block.g_groups == 0 && block.m_groups == 0 && block.words == 0) {
    return block.message.empty() || run_alarm(block);
  }
  Code motion = kNoCode;
  if (!find_motion(block, motion) || !check_words(block, motion)) return false;
  const bool plain = (block.g_groups & ~kMotionGroup) == 0 && block.m_groups == 0 && (block.words & ~kPlainWords) == 0;
  if (!plain) {
    if (block.has(GGroup::feed_mode) && !set_feed_mode(block)) return false;
    if (block.has(GGroup::spindle_mode) && !set_spindle_mode(block)) return false;
  }
  if (block.has('f') && !set_feed(block)) return false;
  if (!plain) {
    if (block.has('s') && !set_speed(block)) return false;
    if (block.has('t') && !select_tool(context_, block)) return false;
    if (block.m_groups != 0 && !run_machine_codes(block)) return false;
    if (!run_dwell(block) || !run_settings(block)) return false;
    out_.set_mode(state_.modal);
    if (block.has(GGroup::once) && !run_once_code(context_, block)) return false;
    if (block.has(GGroup::macro) || !block.message.empty()) {
      if (!run_alarm(block)) return false;
    }
  }
  if (motion != kNoCode) {
    if (!is_cycle(motion)) state_.cycle.initial_level.reset();
    if (!(is_lathe_cycle(motion) ? turn_contour(block, motion) : run_motion(context_, block, motion))) return false;
  }
  if (plain) return !modal_call_.active || run_macro_code(block);
  return run_macro_code(block) && run_stop(block);
}

bool Interpreter::run_machine_codes(const Block& block) {
  if (block.has(MGroup::tool) && !change_tool(context_, block)) return false;
  if (block.has(MGroup::spindle)) {
    const Code code = block.code(MGroup::spindle);
    state_.modal.spindle_direction = code == 3 ? 1 : code == 4 ? -1 : 0;
  }
  if (block.has(MGroup::state) && !run_saved_state(block.code(MGroup::state))) return false;
  if (block.has(MGroup::coolant)) {
    const Code code = block.code(MGroup::coolant);
    state_.modal.mist = code == 7 || (code == 8 && state_.modal.mist);
    state_.modal.flood = code == 8 || (code == 7 && state_.modal.flood);
  }
  if (block.has(MGroup::user)) {
    faults_.warn("m-code-user",
                 fmt::format("M{} is defined by the machine; it is taken to move nothing", block.code(MGroup::user)),
                 "", block.column_of(MGroup::user));
  }
  return true;
}

bool Interpreter::run_saved_state(Code code) {
  auto& saved = flow_.saved_modal();
  if (code == 70 || code == 73) {
    saved = SavedModal{state_.modal, code == 73};
  } else if (code == 71) {
    saved.reset();
  } else {
    if (!saved)
      return faults_.fail("state-not-saved", "M72 without a saved state",
                          "save it with M70 in the same program or sub-program");
    restore(saved->modal);
  }
  return true;
}

void Interpreter::restore(const Modal& saved) {
  Modal& modal = state_.modal;
  const Code motion = modal.motion;
  const int system = saved.system;
  const bool other_system = modal.system != system;
  const Code compensation = modal.compensation;
  modal = saved;
  modal.motion = motion;
  modal.compensation = compensation;
  if (other_system) activate_system(context_, system);
}

bool Interpreter::run_dwell(const Block& block) {
  if (block.code(GGroup::once) != 40) return true;
  const std::size_t column = block.column_of(GGroup::once);
  const bool milliseconds = dialect_ == Dialect::fanuc || is_for_printers_;
  double seconds = 0.0;
  if (block.has('p')) {
    seconds = milliseconds ? block.of('p') / 1000.0 : block.of('p');
  } else if (dialect_ != Dialect::linuxcnc && (block.has('x') || block.has('s'))) {
    seconds = block.of(block.has('x') ? 'x' : 's');
  } else {
    return faults_.fail("dwell-without-time", "G4 without a time", "give it with P", column);
  }
  if (!is_dwell(seconds)) {
    return faults_.fail("dwell-negative", fmt::format("a dwell of {:g} s", seconds), "give a time of 0 to 1e9 s",
                        column);
  }
  out_.set_mode(state_.modal);
  out_.dwell(seconds);
  return true;
}

bool Interpreter::run_stop(const Block& block) {
  if (block.has(MGroup::stop)) {
    const Code code = block.code(MGroup::stop);
    const bool ends = code == 2 || code == 30;
    out_.note(ends ? MoveKind::end : MoveKind::stop, fmt::format("M{}", code));
    if (ends) end_ = End::ended;
  }
  return !block.has(MGroup::subprogram) || run_subprogram_code(block);
}

bool Interpreter::run_subprogram_code(const Block& block) {
  const std::size_t column = block.column_of(MGroup::subprogram);
  if (block.code(MGroup::subprogram) == 99) {
    const auto to = block.has('p') ? std::optional(block.of('p')) : std::nullopt;
    if (flow_.return_from_call(to)) {
      if (const auto modal = flow_.take_restored()) restore(*modal);
      return true;
    }
    faults_.warn("program-repeats", "M99 makes the program begin again without end; it is read once", "end it with M30",
                 column);
    out_.note(MoveKind::end, "M99");
    end_ = End::ended;
    return true;
  }
  if (!block.has('p')) return faults_.fail("m98-without-p", "M98 without P", "name the sub-program with P", column);
  double number = block.of('p');
  double repeats = block.of('l', 1.0);
  if (dialect_ == Dialect::fanuc && !block.has('l') && number >= 10000.0) {  // P00021000: twice O1000
    repeats = std::floor(number / 10000.0);
    number -= repeats * 10000.0;
  }
  const auto times = whole_number(repeats, 0, kMostCalls);
  if (!times)
    return faults_.fail("call-repeats", fmt::format("{:g} repeats of a call", repeats),
                        "L is a whole number from 0 to 999999999", column);
  return flow_.call_number(number, *times, block.column_of('p'), std::nullopt);
}

}  // namespace toolpace::nc
