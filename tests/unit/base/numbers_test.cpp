#include "toolpace/base/numbers.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace toolpace {
namespace {

TEST(Numbers, TextReadsBackToTheSameDouble) {
  for (const double value : {0.1, 1.0 / 3, 1e-300, -5.0, 123456789.125, 4.9e-324}) {
    EXPECT_EQ(std::strtod(to_text(value).c_str(), nullptr), value) << to_text(value);
  }
}

TEST(Numbers, TextIsTheShortestThatDoes) {
  EXPECT_EQ(to_text(0.1), "0.1");
  EXPECT_EQ(to_text(100.0), "100");
  EXPECT_EQ(to_text(-0.25), "-0.25");
}

}  // namespace
}  // namespace toolpace
