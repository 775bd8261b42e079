#include "toolpace/machine/startup_code.h"

#include <algorithm>
#include <string>

#include "toolpace/base/numbers.h"
#include "toolpace/machine/importer.h"

namespace toolpace {
namespace {

constexpr double kMmPerInch = 25.4;

/// A letter and its number.
struct CodeWord {
  char letter;
  double value;
  std::size_t at, length;  ///< of the number
};

/// The next word from `at` on; `at` is then behind it.
std::optional<CodeWord> next_word(const std::string& codes, std::size_t& at) {
  for (; at < codes.size(); ++at) {
    if (codes[at] == ';' || codes[at] == '(' || codes[at] == '#') break;  // a remark
    if (codes[at] < 'A' || codes[at] > 'Z') continue;
    const char letter = codes[at];
    const std::size_t begin = codes.find_first_not_of(' ', at + 1);
    if (begin == std::string::npos) break;
    const std::size_t end = std::min(codes.find_first_not_of("0123456789.+-", begin), codes.size());
    const auto value = parse_number(std::string_view(codes).substr(begin, end - begin));
    at = std::max(end, at + 1);
    if (value) return CodeWord{letter, *value, begin, end - begin};
    --at;
  }
  at = codes.size();
  return std::nullopt;
}

}  // namespace

StartupCode read_startup_code(std::string_view text) {
  const std::string codes = upper(text);
  StartupCode code;
  bool is_of_g64 = false;
  for (std::size_t at = 0; const auto word = next_word(codes, at);) {
    const bool is_g = word->letter == 'G';
    if (is_g && (word->value == 20 || word->value == 21)) code.unit = word->value == 20 ? kMmPerInch : 1.0;
    if (is_g && (word->value == 61 || word->value == 61.1 || word->value == 64)) {
      const double unit = code.unit;
      code = {};
      code.unit = unit;
      if (word->value != 64)
        code.control = word->value == 61 ? StartupCode::Control::exact_path : StartupCode::Control::exact_stop;
    }
    if (is_g || word->letter == 'M') is_of_g64 = is_g && word->value == 64;
    if (is_of_g64 && word->letter == 'P') {
      code.control = StartupCode::Control::blend;
      code.tolerance = word->value;
      code.at = word->at;
      code.length = word->length;
    }
    if (is_of_g64 && word->letter == 'Q') code.naive = word->value;
  }
  if (code.tolerance) *code.tolerance *= code.unit;
  if (code.naive) *code.naive *= code.unit;
  return code;
}

}  // namespace toolpace
