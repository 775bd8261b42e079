#include "toolpace/base/numbers.h"

#include <array>
#include <charconv>

namespace toolpace {

void append_text(std::string& out, double value) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  out.append(buffer.data(), end);
}

std::string to_text(double value) {
  std::string text;
  append_text(text, value);
  return text;
}

}  // namespace toolpace
