#include "toolpace/nc/dialects/integers.h"

#include <algorithm>

#include "toolpace/nc/text/scanner.h"

namespace toolpace::nc {
namespace {

constexpr std::size_t kBytesLookedAt = std::size_t{256} * 1024;
constexpr double kLargeCount = 1000.0;  // 1 mm, 0.1 in: some coordinate of a part is larger
constexpr double kSmallCount = 50.0;    // 0.05 mm: hardly any is smaller

struct Coordinates {
  bool has_points = false;
  std::size_t first_line = 0;
  double largest = 0.0, smallest = 1e300;
};

// K may be a number of repeats.
bool is_coordinate(char letter) { return std::string_view("xyzuvwijr").find(letter) != std::string_view::npos; }

// Macro calls, data and times take other numbers.
bool says_other_numbers(std::string_view line) {
  if (line.find_first_of("#[") != std::string_view::npos) return true;
  Scanner text(line);
  for (char c = text.peek(); c != '\0' && c != '(' && c != ';'; c = text.peek()) {
    text.take();
    double value = 0.0;
    if (c == 'g' && is_digit(text.peek()) && text.take_number(value) == NumberStatus::ok &&
        (value == 4.0 || value == 10.0 || value == 65.0 || value == 66.0 || value >= 100.0))
      return true;
  }
  return false;
}

void look_at(std::string_view line, std::size_t number, Coordinates& found) {
  Scanner text(line);
  for (char c = text.peek(); c != '\0' && c != '(' && c != ';'; c = text.peek()) {
    text.take();
    if (!is_letter(c)) continue;
    const char sign = text.peek();
    const char* const begin = text.position();
    double value = 0.0;
    if (!(is_digit(sign) || sign == '-' || sign == '+' || sign == '.') || text.take_number(value) != NumberStatus::ok)
      continue;
    if (!is_coordinate(c) || value == 0.0) continue;
    if (std::string_view(begin, static_cast<std::size_t>(text.position() - begin)).find('.') !=
        std::string_view::npos) {
      found.has_points = true;
      continue;
    }
    if (found.first_line == 0) found.first_line = number;
    found.largest = std::max(found.largest, std::max(value, -value));
    found.smallest = std::min(found.smallest, std::max(value, -value));
  }
}

}  // namespace

IntegerUse look_at_integers(std::string_view text) {
  text = text.substr(0, kBytesLookedAt);
  Coordinates found;
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    if (!says_other_numbers(text.substr(0, length))) look_at(text.substr(0, length), line, found);
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  const bool large = found.first_line != 0 && found.largest >= kLargeCount && found.smallest >= kSmallCount;
  return {large && !found.has_points, found.first_line};
}

}  // namespace toolpace::nc
