#include "toolpace/nc/text/expression.h"

#include <gtest/gtest.h>

#include <string>

namespace toolpace::nc {
namespace {

struct Evaluation {
  Parameters parameters;
  FaultSink faults;

  double operator()(std::string_view text) {
    double value = 0.0;
    Scanner scanner(text);
    EXPECT_TRUE(ExpressionReader(parameters, faults, false).read_value(scanner, value)) << text;
    EXPECT_EQ(scanner.peek(), '\0') << text;
    return value;
  }
  std::string fault(std::string_view text) {
    double value = 0.0;
    Scanner scanner(text);
    faults.clear();
    if (ExpressionReader(parameters, faults, false).read_value(scanner, value)) return "";
    return faults.list().back().code;
  }
};

TEST(Expression, OperatorsBindByLevelAndGoFromLeftToRight) {
  Evaluation of;
  EXPECT_EQ(of("[2 + 3 * 2 ** 2]"), 14.0);
  EXPECT_EQ(of("[2 ** 3 ** 2]"), 64.0);  // (2³)²
  EXPECT_EQ(of("[5 - 3 - 1]"), 1.0);
  EXPECT_EQ(of("[100 / 10 / 5]"), 2.0);
  EXPECT_EQ(of("[1 OR 0 AND 0]"), 0.0);  // one level: (1 OR 0) AND 0
  EXPECT_EQ(of("[1 + 3 GT 2 * 5]"), 0.0);
  EXPECT_EQ(of("[[1 + 2] * [3 + 4]]"), 21.0);
  EXPECT_EQ(of("[2 * 3 ** 2 * 2 + 1]"), 37.0);
}

TEST(Expression, FanucAssignsWithoutBrackets) {
  Parameters parameters;
  FaultSink faults;
  const auto assigned = [&](std::string_view text, char next) {
    double value = 0.0;
    Scanner scanner(text);
    EXPECT_TRUE(ExpressionReader(parameters, faults, true).read_assigned(scanner, value)) << text;
    EXPECT_EQ(scanner.peek(), next) << text;
    return value;
  };
  EXPECT_EQ(assigned("360.*2/8", '\0'), 90.0);
  EXPECT_EQ(assigned("1+2*[3-1]", '\0'), 5.0);
  EXPECT_EQ(assigned("4 (four)", '('), 4.0);
  EXPECT_EQ(assigned("1+1]", ']'), 2.0);  // left for the block reader to refuse
  double value = 0.0;
  Scanner unclosed("[1+2");
  EXPECT_FALSE(ExpressionReader(parameters, faults, true).read_assigned(unclosed, value));
}

TEST(Expression, ModuloIsNeverNegative) {
  Evaluation of;
  EXPECT_EQ(of("[-7 MOD 4]"), 1.0);
  EXPECT_EQ(of("[-7 MOD -4]"), 1.0);
  EXPECT_EQ(of("[7 MOD 4]"), 3.0);
}

TEST(Expression, FunctionsTakeDegrees) {
  Evaluation of;
  EXPECT_NEAR(of("SIN[30]"), 0.5, 1e-15);
  EXPECT_NEAR(of("ATAN[1]/[-1]"), 135.0, 1e-12);
  EXPECT_NEAR(of("acos[0]"), 90.0, 1e-12);
  EXPECT_EQ(of("FIX[-2.5]"), -3.0);
  EXPECT_EQ(of("FUP[-2.5]"), -2.0);
  EXPECT_EQ(of("ROUND[2.5]"), 3.0);
  EXPECT_EQ(of("ROUND[-2.5]"), -3.0);
  EXPECT_EQ(of("-[3 + 4]"), -7.0);
  EXPECT_EQ(of("S Q R T[16]"), 4.0);
}

TEST(Expression, ParametersMayNameParameters) {
  Evaluation of;
  of.parameters.set_numbered(5, 3.0);
  of.parameters.set_numbered(3, 9.0);
  of.parameters.set_named("spacedname", 4.0);
  EXPECT_EQ(of("##5"), 9.0);
  EXPECT_EQ(of("#[2 + 1]"), 9.0);
  EXPECT_EQ(of("#< Spaced Name >"), 4.0);
  EXPECT_EQ(of("EXISTS[#<spacedname>]"), 1.0);
  EXPECT_EQ(of("EXISTS[#<other>]"), 0.0);
}

TEST(Expression, NumbersCompareEqualWithinATenThousandth) {
  Evaluation of;
  EXPECT_EQ(of("[1 EQ 1.00005]"), 1.0);
  EXPECT_EQ(of("[1 NE 1.001]"), 1.0);
}

TEST(Expression, FaultsAreTold) {
  Evaluation of;
  EXPECT_EQ(of.fault("[1 / 0]"), "division-by-zero");
  EXPECT_EQ(of.fault("SQRT[-1]"), "function-domain");
  EXPECT_EQ(of.fault("LN[0]"), "function-domain");
  EXPECT_EQ(of.fault("[-8 ** 0.5]"), "power-of-negative");
  EXPECT_EQ(of.fault("[10 ** 400]"), "number-too-large");
  EXPECT_EQ(of.fault("#<never>"), "parameter-undefined");
  EXPECT_EQ(of.fault("#1.5"), "parameter-not-integer");
  EXPECT_EQ(of.fault("#9999"), "parameter-out-of-range");
  EXPECT_EQ(of.fault("[1 + 2"), "bracket-missing");
  EXPECT_EQ(of.fault("[1 ? 2]"), "operator-unknown");
  EXPECT_EQ(of.fault("nan"), "function-unknown");
  EXPECT_EQ(of.fault(std::string(5000, '[') + "1"), "nesting-too-deep");
  EXPECT_EQ(of.fault(std::string(5000, '-') + "#1"), "nesting-too-deep");
}

}  // namespace
}  // namespace toolpace::nc
