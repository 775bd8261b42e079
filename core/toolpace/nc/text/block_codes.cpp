/// The codes of a block, G and M: their modal groups, and what the dialect makes of them.

#include <fmt/format.h>

#include <cmath>

#include "toolpace/nc/text/block_reader.h"

namespace toolpace::nc {
namespace {

constexpr double kCodeWithin = 1e-3;                              // tenths
constexpr double kFirstLongCode = 1000, kHighestLongCode = 9999;  // G codes that machines of Fanuc's kind define
constexpr double kHeidenhainTip = 128;
constexpr Code kFractionalCode = 30000;  // M codes of printers with a decimal

// "U3.11.0" is no number.
bool reads_as_words(Scanner text) {
  char c = text.peek();
  for (; is_letter(c); c = text.peek()) {
    double value = 0.0;
    text.take();
    if (is_digit(text.peek()) || text.peek() == '-' || text.peek() == '.') {
      if (text.take_number(value) != NumberStatus::ok) return false;
    }
  }
  return c == '\0' || c == '(' || c == ';' || c == '*';
}

}  // namespace

std::string code_text(char letter, Code code) {
  if (code >= kMillCodes && letter == 'G') return code_text(letter, static_cast<Code>(code - kMillCodes));
  if (code >= kForeignCodes && letter == 'G') return code_text(letter, static_cast<Code>(code - kForeignCodes));
  return code % 10 == 0 || letter == 'M' ? fmt::format("{}{}", letter, letter == 'M' ? code : code / 10)
                                         : fmt::format("{}{}.{}", letter, code / 10, code % 10);
}

// G90 and G94 of lathes beside G0 to G3: as G-code system B has them, absolute and feed a minute.
bool BlockReader::take_system_b(Code code, std::size_t column, Block& block) {
  constexpr auto kMotion = static_cast<std::size_t>(GGroup::motion);
  const auto is_cycle = [](Code c) { return c == kLatheTurning || c == kLatheFacing; };
  const auto is_plain = [](Code c) { return c == 0 || c == 10 || c == 20 || c == 30; };
  const Code other = block.g[kMotion];
  const bool both = is_cycle(code) && is_cycle(other) && code != other;
  if (!both && !(is_cycle(code) && is_plain(other)) && !(is_plain(code) && is_cycle(other))) return false;
  const Code cycle = both ? kLatheTurning : is_cycle(code) ? code : other;
  block.g[kMotion] = both ? kLatheFacing : is_cycle(code) ? other : code;
  const auto group = cycle == kLatheFacing ? GGroup::feed_mode : GGroup::distance;
  block.g_groups |= 1u << static_cast<unsigned>(group);
  block.g[static_cast<std::size_t>(group)] = cycle == kLatheFacing ? 940 : 900;
  if (both) return true;  // G94 without an end is told of later
  faults_.warn("lathe-system-b",
               fmt::format("{} beside {} is read as in G-code system B", code_text('G', cycle),
                           code_text('G', block.g[kMotion])),
               "in system A it is a cycle: give X and Z", column);
  return true;
}

bool BlockReader::read_g(double value, std::size_t column, Block& block) {
  const double tenths = std::round(value * 10.0);
  const bool plausible = std::fabs(value * 10.0 - tenths) < kCodeWithin && tenths >= 0.0 && tenths < 10000.0;
  const auto use = plausible ? rules_.g_code(static_cast<Code>(tenths)) : std::nullopt;
  if (!use && rules_.macro_statements && value >= kFirstLongCode && value <= kHighestLongCode) {
    faults_.warn("g-code-machine", fmt::format("G{:g} is defined by the machine; it is taken to move nothing", value),
                 "", column);
    block.g_groups |= 1u << static_cast<unsigned>(GGroup::machine);
    return true;
  }
  if (!use) {
    if (const char* const does = plausible ? rules_.unfollowed(static_cast<Code>(tenths)) : nullptr) {
      return faults_.fail("g-code-unfollowed", fmt::format("G{:g} {}, which is not followed here", value, does),
                          "post the program without it", column);
    }
    return faults_.fail("g-code-unknown", fmt::format("unknown code G{:g}", value), "check the code or the dialect",
                        column);
  }
  const Code code = use->means == kNoCode ? static_cast<Code>(tenths) : use->means;
  if (!use->by_dialect) {
    const std::string what = fmt::format("{} is no code of the dialect {}", code_text('G', static_cast<Code>(tenths)),
                                         dialect_name(rules_.dialect));
    if (rules_.refuses_doubtful)
      return faults_.fail("g-code-unknown", what, "choose the dialect with --dialect", column);
    faults_.warn("code-not-in-dialect", what + "; it is read as controllers that have it do",
                 "check what your controller does with it", column);
  }
  const auto group = static_cast<std::size_t>(use->group);
  if (use->group == GGroup::ignored || use->group == GGroup::kept) {
    faults_.warn("g-code-ignored", fmt::format("{} has no effect on the path here", code_text('G', code)), "", column);
    block.g_groups |= 1u << group;
    return true;
  }
  if (use->group == GGroup::machine) {
    faults_.warn("g-code-machine",
                 fmt::format("{} is defined by the machine; it is taken to move nothing", code_text('G', code)), "",
                 column);
    block.g_groups |= 1u << group;
    return true;
  }
  if (use->group == GGroup::motion && block.has(GGroup::motion) && (code == 800 || block.g[group] == 800)) {
    if (code != 800) block.g[group] = code;  // G80 beside another motion code only ends what cycle is on
    return true;
  }
  if (use->group == GGroup::motion && block.has(GGroup::motion) && take_system_b(code, column, block)) return true;
  if (block.has(use->group) && rules_.last_code_wins) {
    faults_.warn("modal-group-twice",
                 fmt::format("{} and {} belong to the same modal group; the last counts",
                             code_text('G', block.g[group]), code_text('G', code)),
                 "", column);
  } else if (block.has(use->group)) {
    return faults_.fail(
        "modal-group-twice",
        fmt::format("{} and {} belong to the same modal group", code_text('G', block.g[group]), code_text('G', code)),
        "keep one of them in this block", column);
  }
  block.g_groups |= 1u << group;
  block.g[group] = code;
  block.g_column[group] = static_cast<std::uint32_t>(column);
  return true;
}

bool BlockReader::read_m(double value, std::size_t column, Block& block) {
  const double whole = std::round(value);
  const bool plausible = std::fabs(value - whole) < kCodeWithin && whole >= 0.0 && whole < 30000.0;
  const auto use = plausible ? rules_.m_code(static_cast<int>(whole)) : std::nullopt;
  if (whole == kHeidenhainTip && rules_.dialect == Dialect::linuxcnc && !rules_.refuses_doubtful) {
    return faults_.fail("g-code-unfollowed",
                        "M128 moves the tool's tip while rotary axes turn (Heidenhain), which is not followed here",
                        "use G43.4 H or G43.5 H, or read the whole program so with --tcp", column);
  }
  if (!use && rules_.texts_without_quotes && value >= 0.0) {  // M862.3 P "MK3"
    block.m_groups |= 1u << static_cast<unsigned>(MGroup::ignored);
    block.m[static_cast<std::size_t>(MGroup::ignored)] = kFractionalCode;
    return true;
  }
  if (!use) {
    return faults_.fail("m-code-unknown", fmt::format("unknown code M{:g}", value), "check the code or the dialect",
                        column);
  }
  const auto code = static_cast<Code>(whole);
  if (!use->by_dialect) {
    faults_.warn("code-not-in-dialect",
                 fmt::format("M{} is no code of the dialect {}", code, dialect_name(rules_.dialect)),
                 "check what your controller does with it", column);
  }
  if (use->group == MGroup::ignored) {
    faults_.warn("m-code-ignored", fmt::format("M{} has no effect on the path here", code), "", column);
  }
  const auto group = static_cast<std::size_t>(use->group);
  if (block.has(use->group) && use->group != MGroup::ignored && rules_.last_code_wins) {
    faults_.warn("modal-group-twice",
                 fmt::format("M{} and M{} belong to the same modal group; the last counts", block.m[group], code), "",
                 column);
  } else if (block.has(use->group) && use->group != MGroup::ignored) {
    return faults_.fail("modal-group-twice",
                        fmt::format("M{} and M{} belong to the same modal group", block.m[group], code),
                        "keep one of them in this block", column);
  }
  block.m_groups |= 1u << group;
  block.m[group] = code;
  block.m_column[group] = static_cast<std::uint32_t>(column);
  return true;
}

// M117 and its like carry free text up to the end of the line.
bool BlockReader::skip_printer_text(Scanner& text, const Block& block) {
  if (!rules_.texts_without_quotes) return true;
  if (block.has(MGroup::stop) && block.code(MGroup::stop) <= 1) text.move_to(text.end());  // M0 Click to continue
  if (!block.has(MGroup::ignored)) return true;
  const Code code = block.code(MGroup::ignored);
  const bool is_text = code == 117 || code == 118 || code == 23 || code == 28 || code == kFractionalCode;
  if (is_text || text.rest().find('"') != std::string_view::npos || !reads_as_words(text)) text.move_to(text.end());
  return true;
}

}  // namespace toolpace::nc
