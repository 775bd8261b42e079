#include "toolpace/nc/text/scanner.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "toolpace/base/numbers.h"

namespace toolpace::nc {
namespace {

double number_of(std::string_view text) {
  double value = -999.0;
  EXPECT_EQ(Scanner(text).take_number(value), NumberStatus::ok) << text;
  return value;
}

TEST(Scanner, NumbersReadAsTheNearestDouble) {
  EXPECT_EQ(number_of("5."), 5.0);
  EXPECT_EQ(number_of(".5"), 0.5);
  EXPECT_EQ(number_of("-0.1"), -0.1);
  EXPECT_EQ(number_of("+05.0"), 5.0);
  EXPECT_EQ(number_of("0.30000000000000004"), 0.30000000000000004);
  EXPECT_EQ(number_of("123456789012345678901234567890"), 123456789012345678901234567890.0);
}

TEST(Scanner, RandomNumbersReadBackExactly) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> mantissa(-2000.0, 2000.0);
  for (int i = 0; i < 20000; ++i) {
    const double value = mantissa(random);
    EXPECT_EQ(number_of(to_text(value)), value) << to_text(value);
  }
}

TEST(Scanner, BlanksWithinANumberDoNotMatter) {
  EXPECT_EQ(number_of("0 2 . 5"), 2.5);
  EXPECT_EQ(number_of("1\t0."), 10.0);
}

TEST(Scanner, TellsWhatIsNoNumber) {
  double value = 0.0;
  EXPECT_EQ(Scanner("").take_number(value), NumberStatus::none);
  EXPECT_EQ(Scanner(".").take_number(value), NumberStatus::none);
  EXPECT_EQ(Scanner("-").take_number(value), NumberStatus::none);
  EXPECT_EQ(Scanner("1.2.3").take_number(value), NumberStatus::two_points);
  EXPECT_EQ(Scanner(std::string(400, '9')).take_number(value), NumberStatus::too_large);
}

TEST(Scanner, AnExponentIsNoPartOfANumber) {
  Scanner text("1e400");
  double value = 0.0;
  EXPECT_EQ(text.take_number(value), NumberStatus::ok);
  EXPECT_EQ(value, 1.0);
  EXPECT_EQ(text.peek(), 'e');
}

TEST(Scanner, FoldsCaseAndCountsColumnsInTheLineAsWritten) {
  Scanner text("  X 1");
  EXPECT_EQ(text.peek(), 'x');
  EXPECT_EQ(text.column(), 3u);
}

}  // namespace
}  // namespace toolpace::nc
