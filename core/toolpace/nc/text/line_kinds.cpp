#include "toolpace/nc/text/line_kinds.h"

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
