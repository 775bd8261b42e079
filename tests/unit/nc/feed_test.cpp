/// Feedrates in the modes that need more than the F word.

#include <cmath>
#include <numbers>

#include "reading_test_support.h"

namespace toolpace::nc {
namespace {

std::vector<double> feeds(const std::string& text) {
  const auto reading = read_program(text);
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  std::vector<double> result;
  for (std::size_t i = 0; i < reading.moves.size(); ++i) {
    if (is_motion(reading.moves.kind[i]) && reading.moves.kind[i] != MoveKind::rapid)
      result.push_back(reading.moves.feed[i] * 60);
  }
  return result;
}

// 200 m/min on a radius of 25 mm: 200 000/(2π·25) = 1273.24 turns a minute, at 0.2 mm a turn.
TEST(Feed, PerTurnFollowsConstantSurfaceSpeed) {
  const auto f = feeds("G18 G21 G90 G8 M3 G96 D2500 S200\nG95 F0.2\nG0 X25 Z2\nG1 Z-10\nG97 S1000\nG1 Z0\nM2\n");
  EXPECT_NEAR(f.at(0), 0.2 * 200e3 / (2 * std::numbers::pi * 25), 1e-9);
  EXPECT_NEAR(f.at(1), 0.2 * 1000, 1e-9);
}

// Facing from 25 mm to the middle: the limit of 2500/min holds inside r = 12.732 mm. The time in minutes is
// 12.732/(0.2·2500) + ∫ 2πr/(0.2·200 000) dr from 12.732 to 25.
TEST(Feed, FacingTakesTheTimeThatTheTurningSpindleGives) {
  const auto f = feeds("G18 G21 G90 M3 G96 D2500 S200\nG95 F0.2\nG0 X25 Z2\nG1 X0\nG1 X-25\nM2\n");
  const double inner = 200e3 / (2 * std::numbers::pi * 2500);
  const double time = inner / (0.2 * 2500) + std::numbers::pi * (25 * 25 - inner * inner) / (0.2 * 200e3);
  EXPECT_NEAR(25 / f.at(0), time, 1e-12);
  EXPECT_NEAR(f.at(1), f.at(0), 1e-9);
}

TEST(Feed, SurfaceSpeedIsInFeetInInchPrograms) {
  const auto f = feeds("G18 G20 G90 M3 G96 S500\nG95 F0.01\nG0 X1 Z0\nG1 Z-1\nM2\n");
  EXPECT_NEAR(f.at(0), 0.254 * 500 * 304.8 / (2 * std::numbers::pi * 25.4), 1e-9);
}

TEST(Feed, ConstantSurfaceSpeedAtTheMiddleNeedsALimit) {
  EXPECT_EQ(codes(read_program("G18 G21 M3 G96 S200\nG95 F0.2\nG1 Z-1\nM2\n")), (Codes{"spindle-unbounded@3:1"}));
  EXPECT_EQ(codes(read_program("G18 G21 M3 G96 D0 S200\nM2\n")), (Codes{"g96-limit@1:16"}));
}

// A straight "curve" of 30 mm in 1/2 min, and a half circle of radius 10 as a rational curve, 10π mm in 1/4 min.
TEST(Feed, InverseTimeCountsTheLengthOfSplines) {
  const auto line = feeds("G21 G90 G93\nG5 X30 Y0 I10 J0 P-10 Q0 F2\nM2\n");
  EXPECT_NEAR(line.at(0), 60.0, 1e-6);
  const auto arc = feeds("G21 G90 G93\nG5.2 P1 L3\nX0 Y10 P0.7071067811865476\nX10 Y10 P1 F4\nG5.3\nM2\n");
  EXPECT_NEAR(arc.at(0), 10 * std::numbers::pi / 2 * 4, 1e-4);  // a quarter: (0,0) to (10,10) about (10,0)
}

}  // namespace
}  // namespace toolpace::nc
