#include "toolpace/nc/flow/main_program.h"

#include <algorithm>

#include "toolpace/nc/text/line_kinds.h"

namespace toolpace::nc {
namespace {

enum class Ending { none, returns, ends };

/// How a line ends its program: by M99 without P, or by M2 or M30. Comments do not count.
Ending ending_of(Scanner text) {
  double value = 0.0;
  bool returns = false;
  for (char c = text.peek(); c != '\0' && c != ';'; c = text.peek()) {
    if (c == '(') {
      const std::size_t close = text.rest().find(')');
      if (close == std::string_view::npos) break;
      text.move_to(text.position() + close + 1);
      continue;
    }
    text.take();
    if (c == 'p' && returns) return Ending::none;  // M99 P goes on elsewhere
    if (c != 'm' || text.take_number(value) != NumberStatus::ok) continue;
    if (value == 2.0 || value == 30.0) return Ending::ends;
    returns = returns || value == 99.0;
  }
  return returns ? Ending::returns : Ending::none;
}

std::string_view name_of(std::string_view line) {
  const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
  const std::size_t end = std::min(line.find_first_not_of("0123456789", begin + 1), line.size());
  return line.substr(begin, end - begin);
}

/// Sub-programs are short: what goes on for longer is the program itself.
constexpr std::size_t kLookedAt = std::size_t{1} << 20;

}  // namespace

std::optional<MainProgram> find_main_program(std::string_view text) {
  MainProgram current;
  bool has_head = false, returned = false, is_behind = false;
  std::size_t offset = 0;
  for (std::size_t line = 1; offset < std::min(text.size(), kLookedAt); ++line) {
    const std::string_view rest = text.substr(offset);
    const std::string_view content = rest.substr(0, rest.find('\n'));
    if (begins_program_number(Scanner(content))) {
      if (has_head && !returned) return std::nullopt;
      is_behind = has_head;
      has_head = true;
      returned = false;
      current = {offset, line, name_of(content)};
    } else if (!returned && content.find_first_of("mM") != std::string_view::npos) {
      const Ending ending = ending_of(Scanner(content));
      if (ending == Ending::ends) return is_behind ? std::optional(current) : std::nullopt;
      if (ending == Ending::returns && !has_head) return std::nullopt;
      returned = ending == Ending::returns;
    }
    offset += content.size() + 1;
  }
  return std::nullopt;
}

}  // namespace toolpace::nc
