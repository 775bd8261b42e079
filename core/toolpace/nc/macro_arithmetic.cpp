#include "toolpace/nc/macro_arithmetic.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

#include "toolpace/nc/text/decimal_code.h"
#include "toolpace/nc/text/whole_number.h"

namespace toolpace::nc {
namespace {

constexpr int kHighestOperation = 99;
constexpr int kHighestVariable = 9999;

/// What an operation of q and r gives; nothing where there is no such operation.
std::optional<double> result_of(int operation, double before, double q, double r) {
  switch (operation) {
    case 1: return q;
    case 2: return q + r;
    case 3: return q - r;
    case 4: return q * r;
    case 5: return q / r;
    case 11: return bits_of(q) | bits_of(r);
    case 12: return bits_of(q) & bits_of(r);
    case 13: return bits_of(q) ^ bits_of(r);
    case 21: return std::sqrt(q);
    case 22: return std::fabs(q);
    case 23: return q - std::trunc(q / r) * r;
    case 24: return from_decimal_code(q);
    case 25: return to_decimal_code(q);
    case 26: return before * q / r;
    case 27: return std::hypot(q, r);
    case 28: return std::sqrt(q * q - r * r);
    case 31: return q * std::sin(r * kRadiansPerDegree);
    case 32: return q * std::cos(r * kRadiansPerDegree);
    case 33: return q * std::tan(r * kRadiansPerDegree);
    case 34: {
      const double angle = std::atan2(q, r) / kRadiansPerDegree;
      return angle < 0.0 ? angle + 360.0 : angle;
    }
    default: return std::nullopt;
  }
}

std::optional<bool> condition_of(int operation, double q, double r) {
  switch (operation) {
    case 80: return true;
    case 81: return q == r;
    case 82: return q != r;
    case 83: return q > r;
    case 84: return q < r;
    case 85: return q >= r;
    case 86: return q <= r;
    default: return std::nullopt;
  }
}

double operand(const Block& block, char letter) {
  const double value = block.of(letter, 0.0);
  return is_vacant(value) ? 0.0 : value;
}

bool store(Context& context, const Block& block, double value) {
  const auto variable = whole_number(block.of('p'), 1, kHighestVariable);
  if (!variable || context.parameters.is_read_only(*variable)) {
    return context.faults.fail("macro-variable", fmt::format("#{:g} cannot be assigned", block.of('p')),
                               "name the variable with P, such as P#100", block.column_of('p'));
  }
  if (!std::isfinite(value)) {
    return context.faults.fail("macro-undefined", fmt::format("H{:g} has no result here", block.of('h')),
                               "check Q and R", block.column_of('h'));
  }
  context.parameters.set_numbered(*variable, value);
  return true;
}

}  // namespace

bool is_macro_arithmetic(const Block& block) {
  if (block.code(GGroup::macro) != 650 || block.arguments.empty() || block.arguments.front().letter != 'h')
    return false;
  constexpr std::uint32_t kWords = word_bit('h') | word_bit('p') | word_bit('q') | word_bit('r');
  return (block.words & ~kWords) == 0;
}

bool run_macro_arithmetic(Context& context, Flow& flow, const Block& block) {
  const auto operation = whole_number(block.of('h'), 1, kHighestOperation);
  if (!block.has('p'))
    return context.faults.fail("macro-without-p", "G65 H without P", "name the variable with P, such as P#100",
                               block.column_of('h'));
  const double q = operand(block, 'q'), r = operand(block, 'r');
  if (operation == 99) {
    return context.faults.fail("program-alarm", fmt::format("the program raises alarm {:g}: ", block.of('p')),
                               "see to what the program complains of");
  }
  if (operation) {
    if (const auto holds = condition_of(*operation, q, r))
      return !*holds || flow.go_to_number(block.of('p'), block.column_of('p'));
    const auto variable = whole_number(block.of('p'), 1, kHighestVariable);
    const double before = variable ? context.parameters.numbered(*variable) : 0.0;
    if (const auto value = result_of(*operation, is_vacant(before) ? 0.0 : before, q, r))
      return store(context, block, *value);
  }
  return context.faults.fail("macro-operation", fmt::format("H{:g} is no operation of G65", block.of('h')),
                             "check the code or the dialect", block.column_of('h'));
}

}  // namespace toolpace::nc
