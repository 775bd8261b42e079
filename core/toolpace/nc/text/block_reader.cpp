#include "toolpace/nc/text/block_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "toolpace/nc/advice.h"

namespace toolpace::nc {
namespace {

constexpr double kCodeWithin = 1e-3;     // tenths
constexpr Code kFractionalCode = 30000;  // M codes of printers with a decimal

std::string word_text(std::size_t index) {
  if (index == kRadiusWord) return "@";
  if (index == kAngleWord) return "^";
  if (index == kChamferWord) return ",C";
  if (index == kFilletWord) return ",R";
  if (index == kSpindleWord) return "$";
  return std::string(1, static_cast<char>('A' + index));
}

// The parenthesis that closes a comment; where they nest and pair up in the line, the one that pairs with the first.
std::size_t end_of_comment(std::string_view rest, bool nests) {
  const std::size_t first = rest.find(')');
  if (!nests || first == std::string_view::npos) return first;
  int depth = 0;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (rest[i] == '(') ++depth;
    if (rest[i] == ')' && --depth == 0) return i;
  }
  return first;
}

bool follows_digit(const Scanner& text, std::size_t column) {
  return column >= 2 && (is_digit(text.line()[column - 2]) || text.line()[column - 2] == '.');
}

bool follows_bracket(const Scanner& text) {
  const std::size_t column = text.column();
  return column >= 2 && text.line()[column - 2] == ']';
}

}  // namespace

std::string code_text(char letter, Code code) {
  if (code >= kForeignCodes) return code_text(letter, static_cast<Code>(code - kForeignCodes));
  return code % 10 == 0 || letter == 'M' ? fmt::format("{}{}", letter, letter == 'M' ? code : code / 10)
                                         : fmt::format("{}{}.{}", letter, code / 10, code % 10);
}

bool BlockReader::skip_comments(Scanner& text, std::string* last_comment) {
  for (char c = text.peek(); c == '(' || c == ';'; c = text.peek()) {
    if (c == ';') {
      text.move_to(text.end());
      return true;
    }
    const std::string_view rest = text.rest();
    const std::size_t close = end_of_comment(rest, !rules_.refuses_doubtful);
    if (close == std::string_view::npos && !rules_.refuses_doubtful) {
      faults_.warn("comment-not-closed", "a comment that begins with '(' has no ')'; it ends with the line", "",
                   text.column());
      text.move_to(text.end());
      return true;
    }
    if (close == std::string_view::npos) {
      return faults_.fail("comment-not-closed", "a comment that begins with '(' has no ')'",
                          "close the comment with ')'", text.column());
    }
    if (rules_.refuses_doubtful && rest.substr(1, close - 1).find('(') != std::string_view::npos) {
      return faults_.fail("comment-nested", "a comment within a comment",
                          "comments do not nest: remove the inner parenthesis", text.column());
    }
    if (rules_.acts_by_comment && Scanner(rest.substr(1, close - 1)).take_word("abort,")) {
      aborted_ = true;
      const std::string_view why = rest.substr(0, close);
      return faults_.fail("program-abort", fmt::format("the program gives up:{}", why.substr(why.find(',') + 1)),
                          "see to what the program complains of", text.column());
    }
    if (last_comment != nullptr) *last_comment = rest.substr(1, close - 1);
    text.move_to(text.position() + close + 1);
  }
  return true;
}

bool BlockReader::read(Scanner& text, Block& block) {
  block.clear();
  assignments_.clear();
  std::string* const message = rules_.macro_statements ? &block.message : nullptr;
  for (char c = text.peek(); c != '\0'; c = text.peek()) {
    if (is_letter(c)) {
      if (!read_word(text, c, block)) return false;
    } else if (c == '(' || c == ';') {
      if (!skip_comments(text, message)) return false;
    } else if (c == '#') {
      if (!assignments_.read(text)) return false;
    } else if (c == '@' || c == '^' || c == '$') {
      const std::size_t column = text.column();
      text.take();
      double value = 0.0;
      if (!expressions_.read_value(text, value)) return false;
      const std::size_t index = c == '@' ? kRadiusWord : c == '^' ? kAngleWord : kSpindleWord;
      if (!store_word(index, value, column, block)) return false;
    } else if (c == '.' && !rules_.refuses_doubtful && follows_bracket(text)) {
      text.take();  // F[#1*2]. : the point changes nothing
    } else if (c == ',' && rules_.corner_words) {
      if (!read_corner(text, block)) return false;
    } else if (rules_.sender_lines && is_real_time(c)) {
      text.take();
    } else if (c == '*' && rules_.line_checksums) {
      text.move_to(text.end());  // a sender's checksum
    } else {
      return faults_.fail("bad-character", fmt::format("{} begins no word", shown_character(text.rest())),
                          meant_as_word(c), text.column());
    }
  }
  return is_at_end(text) && (assignments_.empty() || assignments_.make());
}

bool BlockReader::read_corner(Scanner& text, Block& block) {
  const std::size_t column = text.column();
  text.take();
  const char c = text.peek();
  if (c != 'c' && c != 'r') {
    return faults_.fail("corner-word", "behind a comma stands neither C nor R",
                        "write ,C for a chamfer or ,R for a rounding; numbers have a decimal point, not a comma",
                        column);
  }
  text.take();
  double value = 0.0;
  return expressions_.read_value(text, value) &&
         store_word(c == 'c' ? kChamferWord : kFilletWord, value, column, block);
}

bool BlockReader::is_at_end(const Scanner& text) {
  if (text.position() == text.end()) return true;
  return faults_.fail("bad-character", "byte 0x00 begins no word", "this is no text: is the file damaged?",
                      text.column());
}

bool BlockReader::fail_without_value(const Scanner& text, char letter, std::size_t column) {
  const bool behind_digit = letter == 'o' && follows_digit(text, column);
  return faults_.fail("number-expected", word_without_number(text, letter),
                      behind_digit ? kMeantZero : meant_as_number(text), column);
}

bool BlockReader::read_word(Scanner& text, char letter, Block& block) {
  const std::size_t column = text.column();
  text.take();
  const char next = text.peek();
  if (!is_digit(next) && next != '-' && !ExpressionReader::begins_value(text)) {
    // Printers take letters alone as switches: G28 X, M84 E.
    const bool is_switch = rules_.texts_without_quotes && letter != 'g' && letter != 'm' && !block.is_empty();
    return is_switch ? store_word(word_index(letter), 0.0, column, block) : fail_without_value(text, letter, column);
  }
  double value = 0.0;
  const char* const begin = text.position();
  if (!expressions_.read_value(text, value)) return false;
  if (!rules_.refuses_doubtful && std::memchr(begin, '.', static_cast<std::size_t>(text.position() - begin)) != nullptr)
    block.pointed |= word_bit(letter);
  if (is_vacant(value)) return true;  // a word with a vacant value is as if it were not there
  if (letter == 'g') return read_g(value, column, block);
  const bool is_argument = block.has(GGroup::macro) && letter != 'n' && letter != 'o';
  if (is_argument) return store_word(word_index(letter), value, column, block);  // M U V W too
  if (letter == 'm') return read_m(value, column, block) && skip_printer_text(text, block);
  if (letter == 'n') {
    if (rules_.refuses_doubtful) {
      return faults_.fail("bad-line-number", "a line number within a block", "N stands at the beginning of the line",
                          column);
    }
    if (value >= 0.0) return true;
    return faults_.fail("bad-line-number", "a line number below 0", "write N and a number from 0", column);
  }
  if (letter == 'o') {
    return faults_.fail("o-word-misplaced", "an O word inside a block",
                        follows_digit(text, column) ? kMeantZero : "an O word stands first in its line", column);
  }
  return store_word(word_index(letter), value, column, block);
}

bool BlockReader::store_word(std::size_t index, double value, std::size_t column, Block& block) {
  if (block.has(GGroup::macro) && index < kRadiusWord)
    block.arguments.push_back({static_cast<char>('a' + index), value});
  const std::uint32_t bit = 1u << index;
  if ((block.words & bit) != 0 && !block.has(GGroup::macro)) {
    if (rules_.last_code_wins) {
      faults_.warn("word-twice", fmt::format("word {} stands twice in this block; the last counts", word_text(index)),
                   "", column);
      block.value[index] = value;
      return true;
    }
    return faults_.fail("word-twice", fmt::format("word {} stands twice in this block", word_text(index)),
                        "remove one of them", column);
  }
  block.words |= bit;
  block.value[index] = value;
  block.column[index] = static_cast<std::uint32_t>(column);
  return true;
}

bool BlockReader::read_g(double value, std::size_t column, Block& block) {
  const double tenths = std::round(value * 10.0);
  const bool plausible = std::fabs(value * 10.0 - tenths) < kCodeWithin && tenths >= 0.0 && tenths < 10000.0;
  const auto use = plausible ? rules_.g_code(static_cast<Code>(tenths)) : std::nullopt;
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
    const std::string what =
        fmt::format("{} is no code of the dialect {}", code_text('G', code), dialect_name(rules_.dialect));
    if (rules_.refuses_doubtful)
      return faults_.fail("g-code-unknown", what, "choose the dialect with --dialect", column);
    faults_.warn("code-not-in-dialect", what + "; it is read as LinuxCNC reads it",
                 "check what your controller does with it", column);
  }
  const auto group = static_cast<std::size_t>(use->group);
  if (use->group == GGroup::ignored) {
    faults_.warn("g-code-ignored", fmt::format("{} has no effect on the path here", code_text('G', code)), "", column);
    block.g_groups |= 1u << group;
    return true;
  }
  if (use->group == GGroup::motion && block.has(GGroup::motion) && (code == 800 || block.g[group] == 800)) {
    if (code != 800) block.g[group] = code;  // G80 beside another motion code only ends what cycle is on
    return true;
  }
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
  if (!rules_.texts_without_quotes || !block.has(MGroup::ignored)) return true;
  const Code code = block.code(MGroup::ignored);
  const bool is_text = code == 117 || code == 118 || code == 23 || code == 28 || code == kFractionalCode;
  if (is_text || text.rest().find('"') != std::string_view::npos) text.move_to(text.end());
  return true;
}

}  // namespace toolpace::nc
