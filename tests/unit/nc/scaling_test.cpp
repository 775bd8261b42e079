/// G51 and G51.1 of Fanuc's kind: what is scaled and mirrored, and what is not.

#include <numbers>

#include "reading_test_support.h"

namespace toolpace::nc {
namespace {

constexpr double kHalfTurn = std::numbers::pi;

TEST(Scaling, LinesAndArcsGrowAboutTheCentre) {
  const auto reading =
      read_program("O1\nG21 G90 G17\nG0 X0 Y0\nG51 X0 Y0 P2000\nG1 X10. Y5. F100\nG2 X20. Y5. R5.\nG50\nG1 X1.\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading, 0), (Values{0, 20, 40, 1}));
  EXPECT_EQ(ends(reading, 1), (Values{0, 10, 10, 10}));
  ASSERT_EQ(reading.moves.arcs.size(), 1u);
  EXPECT_NEAR(reading.moves.arcs[0].centre.x(), 30.0, 1e-9);
  EXPECT_NEAR(reading.moves.arcs[0].sweep, -kHalfTurn, 1e-9);
  // About X10: 20 lies 10 beside it, and 5 at half the size.
  EXPECT_EQ(ends(read_program("O1\nG21 G90\nG51 X10. Y0 P0.5\nG0 X20.\nG50\nM30\n")), (Values{15}));
}

TEST(Scaling, FeedsStayAndInverseTimesCountTheScaledLength) {
  const auto reading = read_program("O1\nG21 G90\nG51 X0 Y0 Z0 P2000\nG1 X10. F100\nG93 X20. F1.\nM30\n");
  EXPECT_NEAR(reading.moves.feed.at(0), 100.0 / 60, 1e-12);
  EXPECT_NEAR(reading.moves.feed.at(1), 20.0 / 60, 1e-12);
}

TEST(Scaling, EachAxisMayHaveItsOwnButArcsMayNot) {
  const auto lines = read_program("O1\nG21 G90 G17\nG51 X0 Y0 I2000 J500\nG0 X10. Y10.\nM30\n");
  EXPECT_EQ(ends(lines, 0), (Values{20}));
  EXPECT_EQ(ends(lines, 1), (Values{5}));
  EXPECT_TRUE(has_code(read_program("O1\nG21 G90 G17\nG51 X0 Y0 I2000 J500\nG2 X10. Y0 R5. F100\nM30\n"),
                       "arc-scaled-unevenly"));
  EXPECT_TRUE(has_code(read_program("O1\nG21\nG51 X0 Y0 P0\nM30\n"), "scale-factor"));
  EXPECT_TRUE(has_code(read_program("O1\nG21\nG51 X0 Y0\nM30\n"), "scale-missing"));
}

// Left of +X is +Y: the offset of 1 mm is not scaled.
TEST(Scaling, LeavesTheToolsRadiusAsItIs) {
  const auto reading =
      read_program("O1\nG21 G90 G17\nG0 X-10. Y0\nG51 X0 Y0 P2000\nG41.1 D2. G1 X0 Y0 F100\nX10.\nG40 X20.\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_NEAR(reading.moves.end.at(2)[1], 1.0, 1e-9);
  EXPECT_NEAR(reading.moves.end.at(2)[0], 20.0, 1e-9);
}

TEST(Scaling, PecksAreNotScaled) {
  const auto reading =
      read_program("O1\nG21 G90\nG0 Z5.\nG51 X0 Y0 Z0 P2000\nG99 G83 X0 Y0 Z-2. R0 Q2. F100\nG80\nM30\n");
  EXPECT_EQ(ends(reading, 2), (Values{5, 5, 0, -2, 0, -1.746, -4, 0}));
}

TEST(Mirroring, TurnsArcsRound) {
  const auto reading =
      read_program("O1\nG21 G90 G17\nG51.1 X50.\nG1 X60. Y0 F100\nG3 X70. Y0 I5. J0\nG50.1 X0\nG1 X1.\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading, 0), (Values{40, 30, 1}));
  ASSERT_EQ(reading.moves.arcs.size(), 1u);
  EXPECT_NEAR(reading.moves.arcs[0].sweep, -kHalfTurn, 1e-9);
  EXPECT_NEAR(reading.moves.arcs[0].centre.x(), 35.0, 1e-9);
}

// Up to the origin and right, the tool on the left: around the corner from (−1, 0) to (0, 1), here mirrored.
TEST(Mirroring, PutsTheToolOnTheOtherSide) {
  const auto reading =
      read_program("O1\nG21 G90 G17\nG51.1 X0\nG0 X0 Y-10.\nG41.1 D2. G1 X0 Y0 F100\nX10.\nG40 X20.\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading, 0), (Values{0, 1, 0, -10, -20}));
  EXPECT_EQ(ends(reading, 1), (Values{-10, 0, 1, 1, 0}));
  ASSERT_EQ(reading.moves.arcs.size(), 1u);
  EXPECT_NEAR(reading.moves.arcs[0].sweep, kHalfTurn / 2, 1e-9);
}

TEST(Mirroring, ComesBeforeScalingAndTurning) {
  // x = −10 mirrored, −20 scaled, turned by 90° about the zero: y = −20.
  const auto reading = read_program(
      "O1\nG21 G90 G17\nG0 X0 Y0\nG51.1 X0\nG51 X0 Y0 P2000\nG68 X0 Y0 R90.\nG0 X10. Y0\nG69\nG50\nG50.1\nG0 X3. "
      "Y0\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_NEAR(reading.moves.end.at(1)[1], -20.0, 1e-9);
  EXPECT_NEAR(reading.moves.end.at(1)[0], 0.0, 1e-9);
  EXPECT_NEAR(reading.moves.end.at(2)[0], 3.0, 1e-9);
}

TEST(Scaling, OfHaasAndMach3) {
  EXPECT_EQ(ends(read_as(Dialect::haas, "G21 G90\nG51 X0 Y0 P2\nG0 X10.\nM30\n")), (Values{20}));
  EXPECT_EQ(ends(read_as(Dialect::haas, "G21 G90\nG101 X0\nG0 X10.\nG100 X0\nG0 X11.\nM30\n")), (Values{-10, 11}));
  EXPECT_EQ(ends(read_as(Dialect::mach3, "G21 G90\nG51 X2 Y3\nG0 X10\nG50\nG0 X1\nM30\n")), (Values{20, 1}));
}

}  // namespace
}  // namespace toolpace::nc
