/// The contour of a report, thinned as it comes.

#include "toolpace/report/report_plots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace toolpace {
namespace {

std::size_t count(const std::string& text, char c) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), c));
}

TEST(ContourPicture, KeepsCornersAndLeavesOutWhatLiesBetween) {
  ContourPicture picture(100, 50);
  for (int k = 0; k <= 5000; ++k) picture.add({k * 0.02, 0, 0}, 50);
  for (int k = 0; k <= 5000; ++k) picture.add({100, k * 0.01, 0}, 50);
  for (int k = 0; k < 5000; ++k) picture.add({100, 50, 0}, 50);  // a dwell
  // 100 mm are 960 pixels, and a corner may be missed by an eighth of one.
  const std::string svg = picture.svg(0, 1);
  EXPECT_EQ(count(svg, 'L'), 2U) << svg;
  EXPECT_NE(svg.find("M20.0 500.0L980.0 "), std::string::npos) << svg;
  EXPECT_NE(svg.find("L980.0 20.0'"), std::string::npos) << svg;
}

TEST(ContourPicture, HoldsCirclesInFewPointsAndLongProgramsInWhatAPageHolds) {
  ContourPicture circle(50, 50), noise(50, 50);
  for (int k = 0; k <= 100000; ++k) {
    const double angle = k * 1e-4 * 2;
    circle.add({25 * std::cos(angle), 25 * std::sin(angle), 0}, 50);
    noise.add({25 * std::sin(1.7 * k), 25 * std::cos(2.3 * k), 0}, 50);
  }
  EXPECT_LT(count(circle.svg(0, 1), 'L'), 2000U);
  EXPECT_GT(count(circle.svg(0, 1), 'L'), 100U);
  EXPECT_LE(count(noise.svg(0, 1), 'L'), 6000U);
}

}  // namespace
}  // namespace toolpace
