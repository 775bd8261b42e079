#include "toolpace/rewrite/program_lines.h"

#include <algorithm>
#include <charconv>
#include <string>

namespace toolpace::detail::rewrite {
namespace {

constexpr std::size_t kFarthestLook = 64;  // lines

bool is_blank(char c) { return c == ' ' || c == '\t'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Takes words one after the other: a letter and a plain number.
class WordCursor {
 public:
  explicit WordCursor(std::string_view text) : text_(text) {}

  /// @return the word's letter in small, '\0' at the end, '?' at anything else
  char next(std::string_view& number) {
    const std::size_t before = at_;
    skip_blanks();
    blank_before_ = at_ > before;
    if (at_ >= text_.size()) return '\0';
    begin_ = at_;
    const char letter = lower(text_[at_]);
    if (letter < 'a' || letter > 'z') return '?';
    is_lower_ = text_[at_++] == letter;
    skip_blanks();
    const std::size_t first = at_;
    if (at_ < text_.size() && (text_[at_] == '-' || text_[at_] == '+')) ++at_;
    std::size_t digits = 0;
    bool point = false;
    for (; at_ < text_.size() && (is_digit(text_[at_]) || (text_[at_] == '.' && !point)); ++at_) {
      point = point || text_[at_] == '.';
      digits += is_digit(text_[at_]) ? 1 : 0;
    }
    number = text_.substr(first, at_ - first);
    return digits == 0 || digits > 15 ? '?' : letter;
  }
  bool blank_before() const { return blank_before_; }
  bool is_lower() const { return is_lower_; }
  /// The word taken last.
  std::string_view word() const { return text_.substr(begin_, at_ - begin_); }

 private:
  void skip_blanks() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0, begin_ = 0;
  bool blank_before_ = false, is_lower_ = false;
};

/// 1, 2, 3 of "1", "01", …; 0 of all others.
int motion_of(std::string_view number) {
  if (number.size() == 2 && number[0] == '0') number.remove_prefix(1);
  return number.size() == 1 && number[0] >= '1' && number[0] <= '3' ? number[0] - '0' : 0;
}

bool take_word(PlainLine& line, char letter, std::string_view number, std::uint32_t& seen) {
  const std::uint32_t bit = 1u << (letter - 'a');
  if ((seen & bit) != 0) return false;
  seen |= bit;
  const bool has_point = number.find('.') != std::string_view::npos;
  switch (letter) {
    case 'g': line.motion = motion_of(number); return line.motion != 0;
    case 'x':
    case 'y':
    case 'z':
      line.axis[static_cast<std::size_t>(letter - 'x')] = number;
      line.has_points = line.has_points && has_point;
      return true;
    case 'i':
    case 'j':
    case 'k':
    case 'r':
      line.has_centre = true;
      line.has_points = line.has_points && has_point;
      return true;
    case 'f': line.feed = number; return number[0] != '-';
    default: return false;
  }
}

}  // namespace

ProgramLines::ProgramLines(std::string_view text) : text_(text) {
  begin_.reserve(text.size() / 16 + 2);
  begin_.push_back(0);
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string_view::npos;) begin_.push_back(++at);
  if (begin_.back() != text.size()) begin_.push_back(text.size());
}

std::string_view ProgramLines::content(std::size_t line) const {
  std::string_view text = whole(line);
  if (!text.empty() && text.back() == '\n') text.remove_suffix(1);
  while (!text.empty() && text.back() == '\r') text.remove_suffix(1);
  return text;
}

std::optional<PlainLine> plain_line(std::string_view content) {
  PlainLine line;
  WordCursor cursor(content);
  std::string_view number;
  std::uint32_t seen = 0;
  for (bool first = true;; first = false) {
    const char letter = cursor.next(number);
    if (letter == '\0') break;
    if (letter == 'n' && first) {
      if (number.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
      line.label = cursor.word();
      continue;
    }
    if (letter == '?' || !take_word(line, letter, number, seen)) return std::nullopt;
    if (!first) line.is_spaced = cursor.blank_before();
    line.is_lower = cursor.is_lower();
  }
  if (line.axis[0].empty() && line.axis[1].empty() && line.axis[2].empty() && !line.has_centre) return std::nullopt;
  return line;
}

double value_of(std::string_view number) {
  if (!number.empty() && number.front() == '+') number.remove_prefix(1);
  double value = 0.0;
  std::from_chars(number.data(), number.data() + number.size(), value);
  return value;
}

namespace {

/// Without what stands in comments; nothing where a comment does not end.
std::optional<std::string> without_comments(std::string_view content) {
  std::string left;
  for (std::size_t i = 0; i < content.size(); ++i) {
    if (content[i] == ';') break;
    if (content[i] == '(') {
      i = content.find(')', i);
      if (i == std::string_view::npos) return std::nullopt;
      continue;
    }
    left += content[i];
  }
  return left;
}

/// Whether a line can have no part in motion, whatever is modal.
bool moves_nothing(std::string_view content) {
  const auto left = without_comments(content);
  if (!left) return false;
  WordCursor cursor(*left);
  std::string_view number;
  while (const char letter = cursor.next(number)) {
    if (letter != 'n' && letter != 'm' && letter != 's' && letter != 't') return false;
  }
  return true;
}

/// Whether a line names one of G0 G1 G2 G3.
bool names_motion(std::string_view content) {
  const auto left = without_comments(content);
  if (!left) return false;
  WordCursor cursor(*left);
  std::string_view number;
  bool found = false;
  while (const char letter = cursor.next(number)) {
    if (letter == '?' || letter == 'o') return false;
    const bool zero = number == "0" || number == "00";
    if (letter == 'g') found = found || zero || motion_of(number) != 0;
  }
  return found;
}

}  // namespace

bool is_motion_named_from(const ProgramLines& lines, std::size_t line) {
  const std::size_t end = std::min(lines.count() + 1, line + kFarthestLook);
  for (; line < end; ++line) {
    const std::string_view content = lines.content(line);
    if (names_motion(content)) return true;
    if (!moves_nothing(content)) return false;
  }
  return line > lines.count();
}

}  // namespace toolpace::detail::rewrite
