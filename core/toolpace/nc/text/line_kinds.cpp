#include "toolpace/nc/text/line_kinds.h"

#include <algorithm>

namespace toolpace::nc {

bool begins_program_number(Scanner text) {
  const char c = text.peek();
  if (c != 'o' && c != ':') return false;
  text.take();
  double number = 0.0;
  if (text.take_number(number) != NumberStatus::ok) return false;
  const char next = text.peek();
  return next == '\0' || next == '(' || next == ';';
}

bool is_sender_macro(Scanner text) {
  text.take();
  const std::string_view rest = text.rest();
  return text.take_word("wait") || text.take_word("msg") ||
         (is_letter(text.peek()) && rest.find('=') != std::string_view::npos);
}

bool is_program_name(Scanner text) {
  const std::string_view rest = text.rest();
  const std::size_t close = rest.find('>');
  if (close == std::string_view::npos) return false;
  text.move_to(text.position() + close + 1);
  const char next = text.peek();
  return next == '\0' || next == '(' || next == ';';
}

bool is_message(Scanner text) {
  constexpr std::string_view kFirst = "mdewl";
  if (kFirst.find(text.peek()) == std::string_view::npos) return false;
  for (const char* word : {"msg", "dlgmsg", "errmsg", "warnmsg", "logmsg"}) {
    Scanner ahead = text;
    if (ahead.take_word(word) && ahead.peek() == '"') return true;
  }
  return false;
}

bool is_number_alone(Scanner text) {
  while (is_digit(text.peek())) text.take();
  const char next = text.peek();
  return next == '\0' || next == '(' || next == ';';
}

bool begins_channel(Scanner text) {
  const char mark = text.peek();
  if (mark != '$' && mark != '!') return false;
  text.take();
  if (mark == '!') {
    if (text.peek() == 'l') text.take();
    return is_digit(text.peek());
  }
  double number = 0.0;
  return text.take_number(number) == NumberStatus::ok && text.peek() == '\0';
}

std::optional<std::size_t> find_stray_motion(std::string_view text) {
  std::optional<std::size_t> found;
  for (std::size_t line = 0; !text.empty(); ++line) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    Scanner scanner(text.substr(0, length));
    text.remove_prefix(std::min(length + 1, text.size()));
    char c = scanner.peek();
    if (c == 'o' || c == ':') return std::nullopt;
    for (; is_letter(c); c = scanner.peek()) {
      scanner.take();
      double number = 0.0;
      if (scanner.take_number(number) != NumberStatus::ok) break;
      if (c == 'm' && number == 99.0) return std::nullopt;
      if (!found && (c == 'x' || c == 'y' || c == 'z')) found = line;
    }
  }
  return found;
}

bool is_macro_line(Scanner text) {
  if (text.peek() == '_' || text.peek() == '@') {
    text.take();
    return is_letter(text.peek());
  }
  for (int letters = 0; letters < 3; ++letters) {
    if (!is_letter(text.peek())) return false;
    text.take();
  }
  return true;
}

}  // namespace toolpace::nc
