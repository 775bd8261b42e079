/// Feeds that are lowered to what a machine can hold.

#include "written_again.h"

namespace toolpace {
namespace {

FeedLimits limits(double acceleration, double block_time = 0.0) {
  FeedLimits limits;
  for (std::size_t axis = 0; axis < 3; ++axis) limits.machine.axes[axis] = {.speed = 200, .acceleration = acceleration};
  limits.block_time = block_time;
  return limits;
}

TEST(PlannedFeeds, LetArcsKeepTheAccelerationOfTheAxes) {
  // 0.995·400 mm/s² on a radius of 4 mm: √(398·4) = 39.899 mm/s = 2393.9 mm/min, rounded down to four digits.
  const std::string text = "G21 G90 G94\nG0 X4 Y0\nG1 F6000\n" + test::chords(4, 0, 2, 200) + "G1 X0 Y0 Z5\nM2\n";
  const auto rewritten = test::written_again(text, {.feeds = limits(400)});
  const std::size_t arc = rewritten.text.find("G3 ");
  ASSERT_NE(arc, std::string::npos) << rewritten.text;
  EXPECT_NE(rewritten.text.find("F2393\n", arc), std::string::npos) << rewritten.text;
  // Behind it the program's own feed comes back.
  EXPECT_NE(rewritten.text.find("\nG1 X0 Y0 Z5 F6000\n"), std::string::npos) << rewritten.text;
}

TEST(PlannedFeeds, AreNeverHigherAndComeBack) {
  const std::string text = "G21 G90 G94\nG0 X4 Y0\nG1 F6000\n" + test::chords(4, 0, 2, 200) + "(rest)\nG1 X0\nM2\n";
  const auto rewritten = test::written_again(text, {.feeds = limits(400)});
  EXPECT_NE(rewritten.text.find("\nF6000\n(rest)\nG1 X0\n"), std::string::npos) << rewritten.text;
  const Moves& moves = rewritten.reading.moves;
  for (std::size_t row = 0; row < moves.size(); ++row) EXPECT_LE(moves.feed[row], 100.0);
  EXPECT_EQ(test::written_again(text, {.feeds = limits(40000)}).text, test::written_again(text).text);
}

TEST(PlannedFeeds, LetNoBlockBeOverBeforeTheNextIsThere) {
  // Corners every millimetre: 1 mm in 20 ms is 50 mm/s.
  std::string text = "G21 G90 G94 F6000\nG0 X0 Y0\n";
  for (int k = 1; k <= 20; ++k) text += fmt::format("G1 X{} Y{}\n", (k + 1) / 2, k / 2);
  const auto rewritten = test::written_again(text + "M2\n", {.feeds = limits(1e6, 0.02)});
  EXPECT_NE(rewritten.text.find("G1 X1 Y0 F3000\nG1 X1 Y1\n"), std::string::npos) << rewritten.text;
}

}  // namespace
}  // namespace toolpace
