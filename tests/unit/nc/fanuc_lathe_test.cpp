/// Programs of Fanuc's lathes, in small ones.

#include <algorithm>

#include "reading_test_support.h"

namespace toolpace::nc {
namespace {

TEST(FanucLathe, DiametersIncrementsAndFeedsATurn) {
  // 0.01 in a turn at 500 a minute: 5 in/min = 127 mm/min.
  const auto reading = read_program(
      "O7\nG20\nT0101\nG97 S500 M3\nG0 X.6 Z.1\nG1 Z-1. F.01\nU.2 W-1.\nG98 G1 X1. F10.\nM30\n", {}, "a.nc");
  EXPECT_EQ(reading.dialect, Dialect::fanuc_lathe);
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading, 0), (Values{7.62, 7.62, 10.16, 12.7}));
  EXPECT_EQ(ends(reading, 2), (Values{2.54, -25.4, -50.8, -50.8}));
  EXPECT_EQ(reading.moves.kind.at(0), MoveKind::tool);
  EXPECT_NEAR(reading.moves.feed.at(2), 127.0 / 60, 1e-12);
  EXPECT_NEAR(reading.moves.feed.at(4), 254.0 / 60, 1e-12);
}

// G96 S100 (m/min) at ∅10 mm: 100000/(10π) = 3183 a minute, held at 2000 by G50.
TEST(FanucLathe, G50LimitsTheSpindle) {
  const auto reading = read_as(Dialect::fanuc_lathe, "G21\nG50 S2000\nG96 S100 M3\nG0 X10.\nG1 Z-1. F.1\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_NEAR(reading.moves.feed.at(1), 0.1 * 2000 / 60, 1e-9);
}

TEST(FanucLathe, SinglePassesComeBackToTheirStart) {
  const auto turn =
      read_as(Dialect::fanuc_lathe, "G21 G97 S1000 M3\nG0 X50. Z2.\nG90 X40. Z-20. F.2\nX30.\nG0 X60.\nM30\n");
  EXPECT_FALSE(turn.refused) << testing::PrintToString(codes(turn));
  EXPECT_EQ(ends(turn, 0), (Values{25, 20, 20, 25, 25, 15, 15, 25, 25, 30}));
  EXPECT_EQ(ends(turn, 2), (Values{2, 2, -20, -20, 2, 2, -20, -20, 2, 2}));
  const auto face = read_as(Dialect::fanuc_lathe, "G21 G97 S1000 M3\nG0 X50. Z2.\nG94 X0. Z-1. F.2\nM30\n");
  EXPECT_EQ(ends(face, 0), (Values{25, 25, 0, 0, 25}));
  EXPECT_EQ(ends(face, 2), (Values{2, -1, -1, 2, 2}));
  const auto thread = read_as(Dialect::fanuc_lathe, "G21 G97 S600 M3\nG0 X22. Z5.\nG92 X19. Z-10. F1.5\nX18.5\nM30\n");
  EXPECT_EQ(ends(thread, 0), (Values{11, 9.5, 9.5, 11, 11, 9.25, 9.25, 11, 11}));
  EXPECT_NEAR(thread.moves.feed.at(2), 1.5 * 600 / 60, 1e-12);
}

TEST(FanucLathe, HolesAreDrilledAlongZ) {
  const auto reading =
      read_as(Dialect::fanuc_lathe, "G21 G97 S1000 M3\nG0 X0. Z10.\nG83 Z-9. R-8. Q4. F.1\nG80\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  const Values z = ends(reading, 2);
  EXPECT_EQ(*std::min_element(z.begin(), z.end()), -9.0);
  EXPECT_EQ(z.back(), 10.0);
  EXPECT_NE(std::find(z.begin(), z.end(), 2.0), z.end()) << "R counts from the initial level";
}

TEST(FanucLathe, SystemBHasItsCyclesUnderOtherNumbers) {
  const auto reading =
      read_as(Dialect::fanuc_lathe_b,
              "G21 G90 G94 F100\nG92 S2000\nG97 S1000 M3\nG0 X50. Z2.\nG77 X40. Z-20.\nG91 G0 X2.\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading, 0), (Values{25, 20, 20, 25, 25, 26}));
  EXPECT_NEAR(reading.moves.feed.at(2), 100.0 / 60, 1e-12);
}

// On Haas's lathes R is a level; on Fanuc's it counts from the level before, and W from R.
TEST(FanucLathe, RThatWouldLeadAwayFromTheWorkIsALevel) {
  const auto level = read_as(Dialect::fanuc_lathe, "G21 G97 S500 M3\nG0 X0 Z10.\nG81 Z-9. R2. F.1\nG80\nM30\n");
  EXPECT_EQ(ends(level, 2), (Values{10, 10, 2, -9, 10}));
  EXPECT_TRUE(has_code(level, "lathe-level"));
  const auto depth = read_as(Dialect::fanuc_lathe, "G21 G97 S500 M3\nG0 X0 Z10.\nG81 W-5. R-8. F.1\nG80\nM30\n");
  EXPECT_FALSE(depth.refused) << testing::PrintToString(codes(depth));
  EXPECT_EQ(ends(depth, 2), (Values{10, 10, 2, -3, 10}));
}

// Radius 10 reads as 12 after U4 (a diameter): X20 is 2 nearer to the axis than it was.
TEST(FanucLathe, G50ShiftsByIncrements) {
  const auto reading = read_as(Dialect::fanuc_lathe, "G21\nG0 X20. Z0\nG50 U4. W-1.\nG0 X20. Z0\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading, 0), (Values{10, 8}));
  EXPECT_EQ(ends(reading, 2), (Values{0, 1}));
}

}  // namespace
}  // namespace toolpace::nc
