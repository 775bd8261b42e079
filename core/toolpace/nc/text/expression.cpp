#include "toolpace/nc/text/expression.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace toolpace::nc {

enum class ExpressionReader::Operator : unsigned char {
  end,
  logical_and,
  logical_or,
  logical_xor,
  eq,
  ne,
  gt,
  ge,
  lt,
  le,
  plus,
  minus,
  times,
  divide,
  modulo,
  power
};

namespace {

using Level = int;
constexpr double kEqualWithin = 1e-4;    // EQ and NE of RS-274/NGC
constexpr double kIntegerWithin = 1e-4;  // how near a parameter number must be to an integer

double modulo(double left, double right) {
  const double rest = std::fmod(left, right);
  return rest < 0.0 ? rest + std::fabs(right) : rest;
}

}  // namespace

bool ExpressionReader::plain_number_follows(Scanner& text) {
  const char c = text.peek_second();
  return is_digit(c) || c == '.';
}

bool ExpressionReader::read_number(Scanner& text, double& value) {
  const std::size_t column = text.column();
  switch (text.take_number(value)) {
    case NumberStatus::ok: return true;
    case NumberStatus::none:
      return faults_.fail("number-expected", "a number is missing here",
                          "write a number, a #parameter or an expression in []", column);
    case NumberStatus::two_points:
      return faults_.fail("bad-number", "a number with two decimal points", "keep one point", column);
    case NumberStatus::too_large: break;
  }
  return faults_.fail("number-too-large", "a number too large to be held", "check the digits", column);
}

bool ExpressionReader::read_compound(Scanner& text, double& value) {
  const char c = text.peek();
  const std::size_t column = text.column();
  if (depth_ > kDeepestNesting) {
    return faults_.fail("nesting-too-deep", fmt::format("more than {} brackets within each other", kDeepestNesting),
                        "split the expression", column);
  }
  ++depth_;
  bool good = false;
  if (c == '[') {
    good = read_bracketed(text, value);
  } else if (c == '#') {
    text.take();
    good = read_parameter(text, value);
  } else if (c == '-' || c == '+') {
    text.take();
    good = read_value(text, value);
    if (c == '-') value = is_vacant(value) ? value : -value;
  } else if (is_letter(c)) {
    good = read_function(text, value);
  } else {
    good = faults_.fail("number-expected",
                        c == '\0' ? "the line ends where a number is wanted" : "a number is missing here",
                        "write a number, a #parameter or an expression in []", column);
  }
  --depth_;
  if (good && std::isinf(value)) {
    return faults_.fail("number-too-large", "the value of this expression is too large to be held",
                        "check the expression", column);
  }
  return good;
}

bool read_name(Scanner& text, FaultSink& faults, std::string& name) {
  const std::size_t column = text.column();
  text.take();  // '<'
  name.clear();
  for (char c = text.peek(); c != '>'; c = text.peek()) {
    if (c == '\0')
      return faults.fail("name-not-closed", "a name that begins with '<' has no '>'", "close the name with '>'",
                         column);
    name.push_back(c);
    text.take();
  }
  text.take();
  if (name.empty()) return faults.fail("name-empty", "an empty name <>", "write a name between < and >", column);
  return true;
}

// [NAME] of a variable that has one.
std::optional<int> ExpressionReader::read_number_name(Scanner& text) const {
  if (!parameters_.has_named_numbers()) return std::nullopt;
  Scanner ahead = text;
  std::string name;
  for (ahead.take(); ahead.peek() != ']'; ahead.take()) {
    if (ahead.peek() == '\0') return std::nullopt;
    name += ahead.peek();
  }
  const auto number = parameters_.number_of(name);
  if (number) {
    ahead.take();
    text = ahead;
  }
  return number;
}

bool ExpressionReader::read_target(Scanner& text, Target& target) {
  const char c = text.peek();
  const std::size_t column = text.column();
  target.index = -1;
  if (c == '<') return read_name(text, faults_, target.name);
  if (fanuc_ && c == '[') {
    if (const auto number = read_number_name(text)) {
      target.index = *number;
      return true;
    }
  }
  double number = 0.0;
  if (!read_value(text, number)) return false;
  const double whole = std::round(number);
  if (!(std::fabs(number - whole) <= kIntegerWithin)) {
    return faults_.fail("parameter-not-integer", fmt::format("parameter number {:g} is not a whole number", number),
                        "use a whole number behind #", column);
  }
  if (!(whole >= 0.0 && whole < kParameterNumbers) || !parameters_.has_number(static_cast<int>(whole))) {
    return faults_.fail("parameter-out-of-range", fmt::format("there is no parameter #{:.15g}", whole),
                        fmt::format("parameters go from #1 to #{}", parameters_.count() - 1), column);
  }
  target.index = static_cast<int>(whole);
  return true;
}

bool ExpressionReader::read_parameter(Scanner& text, double& value) {
  const std::size_t column = text.column();
  Target target;
  if (!read_target(text, target)) return false;
  if (target.index >= 0) {
    value = parameters_.numbered(target.index);
    return true;
  }
  const auto known = parameters_.named(target.name);
  if (!known) {
    return faults_.fail("parameter-undefined", fmt::format("named parameter #<{}> has no value", target.name),
                        "assign it before it is used, or test it with EXISTS[]", column);
  }
  value = *known;
  return true;
}

bool ExpressionReader::read_operator(Scanner& text, Operator& op) {
  struct Entry {
    std::string_view word;
    Operator op;
  };
  static constexpr Entry kEntries[] = {{"]", Operator::end},         {"**", Operator::power},
                                       {"*", Operator::times},       {"/", Operator::divide},
                                       {"+", Operator::plus},        {"-", Operator::minus},
                                       {"mod", Operator::modulo},    {"and", Operator::logical_and},
                                       {"or", Operator::logical_or}, {"xor", Operator::logical_xor},
                                       {"eq", Operator::eq},         {"ne", Operator::ne},
                                       {"gt", Operator::gt},         {"ge", Operator::ge},
                                       {"lt", Operator::lt},         {"le", Operator::le}};
  text.peek();
  for (const auto& entry : kEntries) {
    if ((open_ended_ && entry.op == Operator::end) || !text.take_word(entry.word)) continue;
    op = entry.op;
    return true;
  }
  if (open_ended_) {
    op = Operator::end;
    return true;
  }
  if (text.peek() == '\0') return faults_.fail("bracket-missing", "']' is missing", "close the bracket", text.column());
  return faults_.fail("operator-unknown", fmt::format("'{}' begins no operator", text.peek()),
                      "operators are + - * / ** MOD AND OR XOR EQ NE GT GE LT LE", text.column());
}

bool ExpressionReader::apply(Operator op, double left, double right, std::size_t column, double& value) {
  if (op == Operator::eq || op == Operator::ne) {
    const bool same = is_vacant(left) || is_vacant(right) ? is_vacant(left) && is_vacant(right)
                                                          : std::fabs(left - right) < kEqualWithin;
    value = same == (op == Operator::eq) ? 1.0 : 0.0;
    return true;
  }
  left = number_or_zero(left);
  right = number_or_zero(right);
  if ((op == Operator::divide || op == Operator::modulo) && right == 0.0) {
    return faults_.fail("division-by-zero", "division by zero", "test the divisor before", column);
  }
  switch (op) {
    case Operator::logical_and: value = left != 0.0 && right != 0.0 ? 1.0 : 0.0; break;
    case Operator::logical_or: value = left != 0.0 || right != 0.0 ? 1.0 : 0.0; break;
    case Operator::logical_xor: value = (left != 0.0) != (right != 0.0) ? 1.0 : 0.0; break;
    case Operator::gt: value = left > right ? 1.0 : 0.0; break;
    case Operator::ge: value = left >= right ? 1.0 : 0.0; break;
    case Operator::lt: value = left < right ? 1.0 : 0.0; break;
    case Operator::le: value = left <= right ? 1.0 : 0.0; break;
    case Operator::plus: value = left + right; break;
    case Operator::minus: value = left - right; break;
    case Operator::times: value = left * right; break;
    case Operator::divide: value = left / right; break;
    case Operator::modulo: value = modulo(left, right); break;
    case Operator::power:
      if (left < 0.0 && right != std::floor(right)) {
        return faults_.fail("power-of-negative", "a negative number to a fractional power", "check the base", column);
      }
      value = std::pow(left, right);
      break;
    case Operator::end:
    case Operator::eq:
    case Operator::ne: break;
  }
  if (std::isfinite(value)) return true;
  return faults_.fail("number-too-large", "the value of this expression is too large to be held",
                      "check the expression", column);
}

namespace {
template <class Op>
int level_of(Op op) {
  const auto rank = static_cast<int>(op);
  if (rank == 0) return 0;
  if (rank <= 3) return 1;
  if (rank <= 9) return 2;
  if (rank <= 11) return 3;
  if (rank <= 14) return 4;
  return 5;
}
}  // namespace

// Folds operators that bind at least as tightly as `level` onto `left`; `next` is the operator that follows.
bool ExpressionReader::read_level(Scanner& text, int level, double& left, Operator& next) {
  while (next != Operator::end && level_of(next) >= level) {
    const Operator op = next;
    const std::size_t column = text.column();
    double right = 0.0;
    if (!read_value(text, right) || !read_operator(text, next)) return false;
    while (level_of(next) > level_of(op)) {
      if (!read_level(text, level_of(op) + 1, right, next)) return false;
    }
    if (!apply(op, left, right, column, left)) return false;
  }
  return true;
}

bool ExpressionReader::read_bracketed(Scanner& text, double& value) {
  if (depth_ > kDeepestNesting) {
    return faults_.fail("nesting-too-deep", fmt::format("more than {} brackets within each other", kDeepestNesting),
                        "split the expression", text.column());
  }
  ++depth_;
  text.take();  // '['
  const bool outer_open_ended = std::exchange(open_ended_, false);
  const bool good = read_operators(text, value);
  open_ended_ = outer_open_ended;
  --depth_;
  return good;
}

bool ExpressionReader::read_operators(Scanner& text, double& value) {
  Operator next = Operator::end;
  return read_value(text, value) && read_operator(text, next) && read_level(text, 1, value, next);
}

bool ExpressionReader::read_assigned(Scanner& text, double& value) {
  if (!fanuc_) return read_value(text, value);
  open_ended_ = true;
  const bool good = read_operators(text, value);
  open_ended_ = false;
  return good;
}

}  // namespace toolpace::nc
