#include "toolpace/nc/text/block_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "toolpace/nc/advice.h"

namespace toolpace::nc {
namespace {

std::string word_text(std::size_t index) {
  if (index == kRadiusWord) return "@";
  if (index == kAngleWord) return "^";
  if (index == kChamferWord) return ",C";
  if (index == kFilletWord) return ",R";
  if (index == kLineAngleWord) return ",A";
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

constexpr std::uint32_t kCoordinateBits = kLinearBits | kRotaryBits | kIncrementBits | kCentreBits | word_bit('r');

bool is_whole(std::string_view number) { return number.find_first_not_of("+-0123456789 \t") == std::string_view::npos; }

bool follows_digit(const Scanner& text, std::size_t column) {
  return column >= 2 && (is_digit(text.line()[column - 2]) || text.line()[column - 2] == '.');
}

bool assigns_text(Scanner text) {
  text.take();
  double number = 0.0;
  if (text.take_number(number) != NumberStatus::ok || text.peek() != '=') return false;
  text.take();
  return text.peek() == '"';
}

bool follows_bracket(const Scanner& text) {
  const std::size_t column = text.column();
  return column >= 2 && text.line()[column - 2] == ']';
}

}  // namespace

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
    } else if (c == '#' && !rules_.refuses_doubtful && assigns_text(text)) {
      text.move_to(text.end());  // #301 = "name": texts move nothing
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
    } else if (c == '"' && !rules_.refuses_doubtful && block.m_groups != 0) {
      text.move_to(text.end());  // M225 #1 "a message"
    } else if (c == '%' && !rules_.refuses_doubtful) {
      text.move_to(text.end());  // M30%
    } else if (c == '<' && (block.has(MGroup::subprogram) || block.has(GGroup::macro)) && rules_.macro_statements) {
      if (!read_name(text, faults_, block.called)) return false;
    } else if (c == '/' && !rules_.refuses_doubtful) {
      skip_slash(text);
    } else {
      return faults_.fail("bad-character", fmt::format("{} begins no word", shown_character(text.rest())),
                          meant_as_word(c), text.column());
    }
  }
  return is_at_end(text) && (assignments_.empty() || assignments_.make());
}

// N10 /2 M8: what follows may be deleted.
void BlockReader::skip_slash(Scanner& text) {
  text.take();
  if (is_digit(text.peek())) text.take();
  if (deletes_blocks_) text.move_to(text.end());
}

bool BlockReader::read_corner(Scanner& text, Block& block) {
  const std::size_t column = text.column();
  text.take();
  const char c = text.peek();
  if (c != 'c' && c != 'r' && c != 'a') {
    return faults_.fail(
        "corner-word", "behind a comma stands neither C nor R nor A",
        "write ,C for a chamfer, ,R for a rounding or ,A for the angle of a line; numbers have a decimal "
        "point, not a comma",
        column);
  }
  text.take();
  double value = 0.0;
  const std::size_t index = c == 'c' ? kChamferWord : c == 'r' ? kFilletWord : kLineAngleWord;
  return expressions_.read_value(text, value) && store_word(index, value, column, block);
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
  if (next == '#' && letter == 'p' && block.has(GGroup::macro) && block.has('h')) text.take();  // the variable itself
  if (!expressions_.read_value(text, value)) return false;
  if (!rules_.refuses_doubtful) note_form({begin, static_cast<std::size_t>(text.position() - begin)}, letter, block);
  if (letter == 's' && rules_.macro_statements && text.peek() == '=') {  // S1=2000: of the spindle of that number
    text.take();
    if (!expressions_.read_value(text, value)) return false;
  }
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

// Whether a word is written with a point, or without one where it may count increments.
void BlockReader::note_form(std::string_view number, char letter, Block& block) const {
  if (std::memchr(number.data(), '.', number.size()) != nullptr) {
    block.pointed |= word_bit(letter);
  } else if (rules_.integers_may_count && is_whole(number)) {
    block.counted |= word_bit(letter) & kCoordinateBits;
  }
}

bool BlockReader::store_word(std::size_t index, double value, std::size_t column, Block& block) {
  if (block.has(GGroup::macro) && index < kRadiusWord)
    block.arguments.push_back({static_cast<char>('a' + index), value});
  const std::uint32_t bit = 1u << index;
  if ((block.words & bit) != 0 && rules_.extruder && index == word_index('e')) return true;  // E1.5e-05
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

}  // namespace toolpace::nc
