#include "toolpace/nc/block_words.h"

#include <fmt/format.h>

#include <utility>

#include "toolpace/nc/tool_tip.h"

namespace toolpace::nc {
namespace {

// Codes outside the motion group that take the block's axis words for themselves.
constexpr bool takes_axes(Code code) {
  return code == 100 || code == 280 || code == 300 || code == 520 || code == 920 || code == kLatheOrigin ||
         (code >= kMillCodes && !is_cycle(code));
}

// Settings that do.
bool keeps_axes(const Block& block) {
  const bool names_axes = block.code(GGroup::path_control) == kContourControl;  // G5.1 Q2 X0 Y0 Z0
  return names_axes || block.has(GGroup::macro) || block.has(GGroup::turn_plane) || block.has(GGroup::mirror) ||
         block.has(GGroup::kept) || block.has(GGroup::machine) || block.code(GGroup::scale) == 510 ||
         block.code(GGroup::tool_length) == 431 || block.code(GGroup::tool_length) == 432;
}

constexpr std::uint32_t kSpindleBit = 1u << kSpindleWord;

std::uint32_t words_of_motion(Code motion) {
  switch (motion) {
    case 20:
    case 30: return kCentreBits | word_bit('r') | word_bit('p');
    case 50: return word_bit('i') | word_bit('j') | word_bit('p') | word_bit('q');
    case 51: return word_bit('i') | word_bit('j');
    case 52: return word_bit('p') | word_bit('l');
    case 330:
    case 331: return word_bit('k') | word_bit('i') | kSpindleBit;
    case 760:
      return kCentreBits | word_bit('p') | word_bit('q') | word_bit('r') | word_bit('h') | word_bit('e') |
             word_bit('l') | kSpindleBit;
    case 700: return word_bit('q') | word_bit('d') | word_bit('e') | word_bit('p');
    case 710:
    case 711:
    case 712:
    case 720:
    case 721:
    case 722: return word_bit('q') | word_bit('d') | word_bit('i') | word_bit('r') | word_bit('u') | word_bit('w');
    case 740: return word_bit('r') | word_bit('p') | word_bit('q') | kCentreBits;  // LinuxCNC does not repeat it by L
    case kLatheThread: return word_bit('q') | word_bit('e');
    case kLatheFinish:
    case kLatheRough:
    case kLatheFaceRough:
    case kLatheRepeat:
    case kLatheFaceGroove:
    case kLatheGroove:
    case kLatheThreads:
      return word_bit('p') | word_bit('q') | word_bit('r') | word_bit('d') | word_bit('e') | kCentreBits;
    case kLatheTurning:
    case kLatheFacing:
    case kLatheThreading: return word_bit('r') | word_bit('q') | word_bit('e') | word_bit('i') | word_bit('k');
    default: return is_cycle(motion) ? word_bit('r') | word_bit('l') | word_bit('p') | word_bit('q') | kCentreBits : 0;
  }
}

std::uint32_t words_of_settings(const Block& block) {
  std::uint32_t words = 0;
  const Code once = block.code(GGroup::once);
  if (once == 40) words |= word_bit('p');
  if (once == 300) words |= word_bit('p');
  if (once >= kMillCodes) words |= word_bit('l') | word_bit('q') | word_bit('d') | kCentreBits;
  if (block.has(GGroup::scale)) words |= word_bit('p') | kCentreBits;
  if (once == 100) words |= word_bit('l') | word_bit('p') | word_bit('r') | word_bit('q') | kCentreBits;
  if (block.has(GGroup::compensation)) words |= word_bit('d') | word_bit('l');
  if (block.has(GGroup::tool_length)) words |= word_bit('h');
  if (block.has(GGroup::path_control)) words |= word_bit('p') | word_bit('q');
  if (block.code(GGroup::path_control) == kSmoothness) words |= word_bit('e');
  if (block.code(GGroup::path_control) == kContourControl) words |= word_bit('r');
  if (block.has(GGroup::spindle_mode)) words |= word_bit('d') | kSpindleBit;
  if (block.has('s')) words |= kSpindleBit;
  if (block.code(GGroup::system) == 541) words |= word_bit('p');
  if (block.has(GGroup::macro)) words |= ~0u;
  if (block.has(GGroup::turn_plane)) words |= word_bit('r') | kCentreBits;
  if (block.has(MGroup::tool)) words |= word_bit('q');
  if (block.has(MGroup::io)) words |= word_bit('p') | word_bit('q') | word_bit('e') | word_bit('l');
  if (block.has(MGroup::override_) || block.has(MGroup::user)) words |= word_bit('p') | word_bit('q');
  if (block.has(MGroup::spindle)) words |= word_bit('r') | word_bit('q') | word_bit('p') | kSpindleBit;
  if (block.has(MGroup::subprogram)) words |= word_bit('p') | word_bit('l') | word_bit('q') | word_bit('h');
  if (block.has(MGroup::ignored) || block.has(MGroup::limits) || block.has(GGroup::ignored)) words |= ~0u;
  if (block.has(GGroup::kept) || block.has(GGroup::machine)) words |= ~0u;
  return words;
}

}  // namespace

namespace {

std::uint32_t axis_words(const Context& context) {
  return context.rules.lathe_words ? kAxisBits | kIncrementBits | word_bit('h') : kAxisBits;
}

// G90, G92 and G94 without an end are what G-code system B knows: absolute, the spindle's limit, feed a minute.
bool read_as_system_b(Context& context, const Block& block, Code code) {
  if (code == kLatheFacing) {
    context.state.modal.feed_mode = 940;
    context.state.feed_mode_doubtful = true;
  }
  if (code == kLatheThreading && block.has('s')) context.state.modal.spindle_limit = block.of('s');
  context.faults.warn("lathe-system-b",
                      fmt::format("{} without an end is read as in G-code system B", code_text('G', code)),
                      "in system A it is a cycle: give X and Z", block.column_of(GGroup::motion));
  return true;
}

}  // namespace

bool find_motion(Context& context, const Block& block, Code& motion) {
  const bool axes = block.has_any(axis_words(context));
  const Code once = block.code(GGroup::once);
  const Code named = block.code(GGroup::motion);
  motion = kNoCode;
  const bool claimed = takes_axes(once) || keeps_axes(block) || (once == 40 && context.rules.dwells_by_axis_words) ||
                       block.has(MGroup::limits) ||
                       (block.has(MGroup::ignored) && context.rules.extruder);  // M92 X80: settings
  const bool only_sets_motion = context.rules.motion_beside_home && (named == 0 || named == 10);
  if (claimed && named != kNoCode && named != 800 && takes_axes(once)) {
    if (only_sets_motion) {
      context.state.modal.motion = context.state.plain_motion = named;
      return true;
    }
    return context.faults.fail(
        "two-codes-want-axes",
        fmt::format("{} and {} both use the axis words", code_text('G', once), code_text('G', named)),
        "put them into blocks of their own", block.column_of(GGroup::motion));
  }
  if (once == 40 && !block.has('p') && context.rules.refuses_doubtful) {
    return context.faults.fail("dwell-without-time", "G4 without a time", "give it in seconds with P",
                               block.column_of(GGroup::once));
  }
  const bool extruder_alone = context.rules.extruder && once == 920 && block.has('e');
  const bool limits_spindle = once == 920 && block.has('s') && !context.rules.refuses_doubtful;
  if ((once == 920 || once == 520) && !axes && !extruder_alone && !limits_spindle) {
    const std::string what = fmt::format("{} without axis words", code_text('G', once));
    if (context.rules.refuses_doubtful)
      return context.faults.fail("axes-missing", what, "give at least one axis", block.column_of(GGroup::once));
    context.faults.warn("axes-missing", what, "give at least one axis", block.column_of(GGroup::once));
  }
  if (context.rules.lathe_words && !axes &&
      (named == kLatheTurning || named == kLatheFacing || named == kLatheThreading))
    return read_as_system_b(context, block, named);
  if (named == 800) {
    if (axes && !claimed && !context.rules.refuses_doubtful) {
      motion = context.state.plain_motion;
      context.faults.warn("axes-with-g80",
                          fmt::format("axis words in a block with G80 move by {}", code_text('G', motion)),
                          "put them into a block of their own", block.column_of(GGroup::motion));
      return true;
    }
    if (axes && !claimed) {
      return context.faults.fail("axes-with-g80", "axis words in a block with G80",
                                 "put them into a block with a motion code", block.column_of(GGroup::motion));
    }
    motion = 800;
  } else if (named != kNoCode) {
    motion = named;
  } else if (axes && !claimed) {
    motion = context.state.modal.motion;
    if (motion == 800 && context.rules.refuses_doubtful) {
      return context.faults.fail("axes-without-motion", "axis words while no motion code is active",
                                 "give a motion code such as G0 or G1");
    }
    if (motion == 800) {
      motion = context.state.plain_motion;
      context.faults.warn("axes-without-motion",
                          fmt::format("axis words while no motion code is active move by {}", code_text('G', motion)),
                          "give a motion code such as G0 or G1");
    }
  } else if (!claimed && block.has_any(kCentreBits) &&
             (context.state.modal.motion == 20 || context.state.modal.motion == 30 ||
              (context.state.tip.by_vector && context.state.modal.motion <= 10))) {
    motion = context.state.modal.motion;
  }
  return true;
}

bool check_words(Context& context, const Block& block, Code motion) {
  const std::uint32_t always =
      axis_words(context) | kCornerBits | kLineAngleBit | word_bit('f') | word_bit('s') | word_bit('t');
  std::uint32_t unused = block.words & ~always;
  if (unused == 0) return true;
  if (context.rules.lathe_words && motion == 10) unused &= ~(word_bit('r') | word_bit('i') | word_bit('k'));
  if (context.rules.dwells_by_axis_words && block.code(GGroup::once) == 40) unused &= ~word_bit('u');
  const bool by_vector = context.state.tip.by_vector || block.code(GGroup::tool_length) == kTipByVector;
  if (by_vector && (motion == 0 || motion == 10)) unused &= ~kCentreBits;
  unused &= ~(words_of_motion(motion) | words_of_settings(block));
  if (unused == 0) return true;
  if ((unused & (1u << kSpindleWord)) != 0) {
    return context.faults.fail("word-unused", "nothing in this block uses word $",
                               "$ names the spindle of M3 M4 M5 M19 S G33 G33.1 G76 G96 G97",
                               block.column[kSpindleWord]);
  }
  for (std::size_t i = 0; i < 26; ++i) {
    if ((unused & (1u << i)) == 0) continue;
    if (context.rules.extruder && i == word_index('e')) {
      if (!std::exchange(context.state.extruder_told, true)) {
        context.faults.warn("extruder-ignored", "the extruder E is left out of the path", "", block.column[i]);
      }
      continue;
    }
    if (!context.rules.extruder && (i == word_index('u') || i == word_index('v') || i == word_index('w'))) {
      return context.faults.fail("axis-absent", fmt::format("this machine has no axis {}", static_cast<char>('A' + i)),
                                 "axes are X Y Z A B C", block.column[i]);
    }
    const std::string what = fmt::format("nothing in this block uses word {}", static_cast<char>('A' + i));
    if (context.rules.refuses_doubtful) {
      const char* const remedy = i == word_index('e') ? "remove it; numbers have no exponent here: write them out"
                                                      : "remove it, or add the code it belongs to";
      return context.faults.fail("word-unused", what, remedy, block.column[i]);
    }
    context.faults.warn("word-unused", what, "", block.column[i]);
  }
  return true;
}

}  // namespace toolpace::nc
