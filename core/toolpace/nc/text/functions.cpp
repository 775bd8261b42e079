/// ABS ACOS … TAN and EXISTS.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "toolpace/base/axes.h"
#include "toolpace/nc/text/decimal_code.h"
#include "toolpace/nc/text/expression.h"

namespace toolpace::nc {
namespace {

constexpr double kDegreesPerRadian = 1.0 / kRadiansPerDegree;

// Longer names first where one begins another.
constexpr std::array<std::string_view, 14> kFunctions = {"abs", "acos", "asin", "atan",  "cos", "exists", "exp",
                                                         "fix", "fup",  "ln",   "round", "sin", "sqrt",   "tan"};

constexpr std::array<std::string_view, 5> kMacroFunctions = {"bcd[", "bin[", "pow[", "rnd",
                                                             "sqr"};  // of Fanuc's kind, too

/// Where in "[x,y]…" the comma and the bracket that closes stand; 0 where there is none.
struct Pair {
  std::size_t comma = 0, close = 0;
  bool is_one() const { return comma > 1 && close > comma + 1; }
};

Pair find_pair(std::string_view text) {
  Pair pair;
  int depth = 0;
  for (std::size_t i = 0; i < text.size() && pair.close == 0; ++i) {
    if (text[i] == '[') ++depth;
    if (text[i] == ']' && --depth == 0) pair.close = i;
    if (text[i] == ',' && depth == 1) pair.comma = i;
  }
  return pair;
}

}  // namespace

bool ExpressionReader::read_exists(Scanner& text, double& value) {
  const std::size_t column = text.column();
  Target target;
  if (text.peek() != '[')
    return faults_.fail("bracket-missing", "EXISTS needs [#<name>]", "write EXISTS[#<name>]", column);
  text.take();
  if (text.peek() != '#')
    return faults_.fail("exists-needs-name", "EXISTS needs a named parameter", "write EXISTS[#<name>]", column);
  text.take();
  if (text.peek() != '<') {
    double number = 0.0;
    if (!read_value(text, number)) return false;
    const double whole = std::round(number);
    target.index = whole >= 0.0 && whole < parameters_.count() ? static_cast<int>(whole) : -1;
  } else if (!read_name(text, faults_, target.name)) {
    return false;
  }
  if (text.peek() != ']')
    return faults_.fail("bracket-missing", "']' is missing after EXISTS", "close the bracket", text.column());
  text.take();
  value = target.index > 0 || (!target.name.empty() && parameters_.named(target.name)) ? 1.0 : 0.0;
  return true;
}

bool ExpressionReader::begins_value(Scanner text) {
  const char c = text.peek();
  if (!is_letter(c)) return is_digit(c) || c == '.' || c == '-' || c == '+' || c == '[' || c == '#';
  const auto begins = [&](std::string_view name) { return Scanner(text).take_word(name); };
  return std::any_of(kFunctions.begin(), kFunctions.end(), begins) ||
         std::any_of(kMacroFunctions.begin(), kMacroFunctions.end(), begins);
}

bool ExpressionReader::read_function(Scanner& text, double& value) {
  const std::size_t column = text.column();
  for (const std::string_view name : kFunctions) {
    if (!text.take_word(name)) continue;
    return name == "exists" ? read_exists(text, value) : apply_function(name, column, text, value);
  }
  if (fanuc_) {
    if (text.take_word("pow")) return apply_power(text, value);
    if (text.take_word("sqr")) return apply_function("sqrt", column, text, value);
    if (text.take_word("rnd")) return apply_function("round", column, text, value);
    for (const std::string_view name : {"bin", "bcd"}) {
      if (text.take_word(name)) return apply_function(name, column, text, value);
    }
  }
  return faults_.fail("function-unknown", fmt::format("'{}' begins no function", text.peek()),
                      "functions are ABS ACOS ASIN ATAN COS EXISTS EXP FIX FUP LN ROUND SIN SQRT TAN", column);
}

// [x,y] of POW and ATAN.
bool ExpressionReader::read_pair(Scanner& text, double& x, double& y) {
  const std::size_t column = text.column();
  const Pair pair = find_pair(text.rest());
  const std::string first = fmt::format("[{}]", text.rest().substr(1, pair.comma - 1));
  const std::string second = fmt::format("[{}]", text.rest().substr(pair.comma + 1, pair.close - pair.comma - 1));
  text.move_to(text.position() + pair.close + 1);
  Scanner of_first(first), of_second(second);
  if (read_bracketed(of_first, x) && read_bracketed(of_second, y)) return true;
  return faults_.fail("number-expected", "an argument is missing here", "check the argument", column);
}

bool ExpressionReader::apply_power(Scanner& text, double& value) {
  double base = 0.0, exponent = 0.0;
  const std::size_t column = text.column();
  if (text.peek() != '[' || !find_pair(text.rest()).is_one())
    return faults_.fail("function-domain", "POW needs two arguments", "check the argument", column);
  if (!read_pair(text, base, exponent)) return false;
  value = std::pow(number_or_zero(base), number_or_zero(exponent));
  return std::isfinite(value) ||
         faults_.fail("function-domain", "POW has no result here", "check the argument", column);
}

bool ExpressionReader::apply_function(std::string_view name, std::size_t column, Scanner& text, double& value) {
  if (text.peek() != '[') {
    return faults_.fail("bracket-missing", fmt::format("'[' is missing after {}", name), "put the argument in []",
                        text.column());
  }
  double x = 0.0;
  if (fanuc_ && name == "atan" && find_pair(text.rest()).is_one()) {
    double y = 0.0;
    if (!read_pair(text, x, y)) return false;
    value = std::atan2(number_or_zero(x), number_or_zero(y)) * kDegreesPerRadian;
    return true;
  }
  if (!read_bracketed(text, x)) return false;
  x = number_or_zero(x);
  const auto domain = [&](const char* what) {
    return faults_.fail("function-domain", fmt::format("{}[{:g}]: {}", name, x, what), "check the argument", column);
  };
  if (name == "atan") {
    if (text.peek() != '/') {
      if (!fanuc_)
        return faults_.fail("atan-needs-two", "ATAN needs two arguments", "write ATAN[y]/[x]", text.column());
      value = std::atan(x) * kDegreesPerRadian;
      return true;
    }
    text.take();
    double other = 0.0;
    if (text.peek() != '[')
      return faults_.fail("bracket-missing", "'[' is missing after ATAN[]/", "write ATAN[y]/[x]", text.column());
    if (!read_bracketed(text, other)) return false;
    value = std::atan2(x, number_or_zero(other)) * kDegreesPerRadian;
    return true;
  }
  if (name == "abs") value = std::fabs(x);
  if (name == "acos" || name == "asin") {
    if (!(std::fabs(x) <= 1.0)) return domain("the argument lies outside -1 to 1");
    value = (name == "acos" ? std::acos(x) : std::asin(x)) * kDegreesPerRadian;
  }
  if (name == "cos") value = std::cos(x * kRadiansPerDegree);
  if (name == "sin") value = std::sin(x * kRadiansPerDegree);
  if (name == "tan") value = std::tan(x * kRadiansPerDegree);
  if (name == "exp") value = std::exp(x);
  // Fanuc's go towards zero and away from it.
  if (name == "fix") value = fanuc_ ? std::trunc(x) : std::floor(x);
  if (name == "fup") value = fanuc_ && x < 0.0 ? std::floor(x) : std::ceil(x);
  if (name == "round") value = std::round(x);
  if (name == "bin") value = from_decimal_code(x);
  if (name == "bcd") value = to_decimal_code(x);
  if (name == "ln") {
    if (!(x > 0.0)) return domain("the logarithm needs a positive argument");
    value = std::log(x);
  }
  if (name == "sqrt") {
    if (!(x >= 0.0)) return domain("the square root of a negative number");
    value = std::sqrt(x);
  }
  return true;
}

}  // namespace toolpace::nc
