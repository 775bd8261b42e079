#include "toolpace/base/numbers.h"

#include <gtest/gtest.h>

#include <cmath>

namespace toolpace {
namespace {

TEST(Numbers, TextReadsBackToTheSameDouble) {
  for (const double value : {0.1, 1.0 / 3, 1e-300, -5.0, 123456789.125, 4.9e-324}) {
    EXPECT_EQ(parse_number(to_text(value)), value) << to_text(value);
  }
}

TEST(Numbers, TextIsTheShortestThatDoes) {
  EXPECT_EQ(to_text(0.1), "0.1");
  EXPECT_EQ(to_text(100.0), "100");
  EXPECT_EQ(to_text(-0.25), "-0.25");
}

TEST(Numbers, OnlyAWholeTextIsANumber) {
  for (const char* text : {"", " 1", "1 ", "1x", "0x10", "1,5", "--1", "1e400", "-1e400"})
    EXPECT_EQ(parse_number(text), std::nullopt) << text;
  EXPECT_EQ(parse_number("1e-310"), 1e-310);
  EXPECT_EQ(parse_number("-inf"), -INFINITY);
  EXPECT_TRUE(std::isnan(*parse_number("nan")));
}

}  // namespace
}  // namespace toolpace
