#pragma once
/// Reading of values: numbers, parameters, functions and bracketed expressions, evaluated as they are read.
///
/// Precedence as in RS-274/NGC: ** first; then * / MOD; + -; comparisons; AND OR XOR. Every level goes from left to right.
/// Angles are in degrees.

#include "toolpace/nc/fault.h"
#include "toolpace/nc/text/parameters.h"
#include "toolpace/nc/text/scanner.h"

namespace toolpace::nc {

inline constexpr int kDeepestNesting = 100;  ///< brackets within brackets, so that the stack is safe

class ExpressionReader {
 public:
  ExpressionReader(const Parameters& parameters, FaultSink& faults, bool fanuc)
      : parameters_(parameters), faults_(faults), fanuc_(fanuc) {}

  /// A value as it may follow a word letter: number, #parameter, function or [expression], with sign.
  /// @return false after recording a fault
  bool read_value(Scanner& text, double& value) {
    const char c = text.peek();
    if (is_digit(c) || c == '.') return read_number(text, value);
    if ((c == '-' || c == '+') && plain_number_follows(text)) return read_number(text, value);
    return read_compound(text, value);
  }

  /// Whether something that read_value reads comes next.
  static bool begins_value(Scanner text);

  /// A value as it may follow '=': in Fanuc macros also an expression without brackets, "#1=#1+2.*#3".
  bool read_assigned(Scanner& text, double& value);

  /// "[ … ]"
  bool read_bracketed(Scanner& text, double& value);

  /// What follows '#': "12", "[…]", "#3", "<name>", "[NAME]" of SETVN; the cursor stands behind the '#'.
  struct Target {
    int index = -1;    ///< numbered parameter, or −1
    std::string name;  ///< folded name, where index is −1
  };
  bool read_target(Scanner& text, Target& target);

 private:
  enum class Operator : unsigned char;

  static bool plain_number_follows(Scanner& text);
  bool read_number(Scanner& text, double& value);
  bool read_compound(Scanner& text, double& value);
  bool read_parameter(Scanner& text, double& value);
  bool read_exists(Scanner& text, double& value);
  std::optional<int> read_number_name(Scanner& text) const;
  bool read_function(Scanner& text, double& value);
  bool read_pair(Scanner& text, double& x, double& y);
  bool apply_power(Scanner& text, double& value);
  bool apply_function(std::string_view name, std::size_t column, Scanner& text, double& value);
  bool read_operators(Scanner& text, double& value);
  bool read_operator(Scanner& text, Operator& op);
  bool apply(Operator op, double left, double right, std::size_t column, double& value);
  bool read_level(Scanner& text, int level, double& left, Operator& next);

  const Parameters& parameters_;
  FaultSink& faults_;
  bool fanuc_;
  bool open_ended_ = false;  ///< outside of all brackets an expression ends where no operator follows
  int depth_ = 0;
};

/// Reads "<name>" behind the '#' or 'o'; folds it to lower case without blanks.
bool read_name(Scanner& text, FaultSink& faults, std::string& name);

}  // namespace toolpace::nc
