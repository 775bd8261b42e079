#include "toolpace/nc/advice.h"

#include <fmt/format.h>

namespace toolpace::nc {
namespace {

constexpr bool is_foreign(char c) { return static_cast<unsigned char>(c) >= 0x80; }

bool begins_text(Scanner text) {
  for (int letters = 0; letters < 3; ++letters) {
    if (!is_letter(text.peek())) return false;
    text.take();
  }
  return true;
}

}  // namespace

std::string shown_character(std::string_view rest) {
  const auto byte = [&](std::size_t i) { return i < rest.size() ? static_cast<unsigned char>(rest[i]) : 0u; };
  if (byte(0) >= 0x21 && byte(0) < 0x7F) return fmt::format("'{}'", rest.front());
  const std::size_t length = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : byte(0) >= 0xC2 ? 2 : 1;
  unsigned code = byte(0) & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0u) != 0x80u) return fmt::format("byte 0x{:02X}", byte(0));
    code = (code << 6u) | (byte(i) & 0x3Fu);
  }
  if (length == 1) return fmt::format("byte 0x{:02X}", byte(0));
  return fmt::format("'{}' (U+{:04X})", rest.substr(0, length), code);
}

std::string word_without_number(Scanner text, char letter) {
  std::string what = fmt::format("word {} has no number", static_cast<char>(letter - 'a' + 'A'));
  const char next = text.peek();
  if (next != '\0' && !is_letter(next)) what += ", but " + shown_character(text.rest());
  return what;
}

const char* meant_as_number(Scanner text) {
  if (begins_text(text)) return "is this text? Comments stand in ( ) or behind ;";
  const char next = text.peek();
  switch (next) {
    case 'o': return kMeantZero;
    case 'l':
    case 'i': return "is this letter meant to be the digit 1?";
    case '=': return "leave the = out: X5";
    case ',': return "numbers have a decimal point, not a comma";
    default:
      return is_foreign(next) ? "type digits and signs as plain ASCII characters"
                              : "write a number behind it, a #parameter, or an expression in []";
  }
}

const char* meant_as_word(char c) {
  if (c == ',') return "numbers have a decimal point, not a comma";
  if (c == '/') return "a quotient stands in brackets, such as X[1/2]; comments stand in ( ) or behind ;";
  if (is_foreign(c)) return "outside of comments a program is plain ASCII; numbers carry no unit";
  return "words begin with a plain letter; comments stand in ( ) or behind ;";
}

}  // namespace toolpace::nc
