/// The cycles of Fanuc's lathes, judged by what they leave of the stock.

#include <algorithm>

#include "reading_test_support.h"

namespace toolpace::nc {
namespace {

Reading turned(const std::string& text) { return read_as(Dialect::fanuc_lathe, "G21 G97 S1000 M3\n" + text + "M30\n"); }

/// The least radius that straight feed moves leave of the stock at `z`.
double radius_left_at(const Moves& moves, double z) {
  double least = 1e9;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (moves.kind[i] != MoveKind::feed) continue;
    const AxisVector &a = moves.begin_of(i), &b = moves.end[i];
    if (std::min(a[2], b[2]) > z || std::max(a[2], b[2]) < z) continue;
    const double t = a[2] == b[2] ? 0.0 : (z - a[2]) / (b[2] - a[2]);
    least = std::min(least, a[2] == b[2] ? std::min(a[0], b[0]) : a[0] + t * (b[0] - a[0]));
  }
  return least;
}

// Radius 10 up to Z-10, a cone to 15 at Z-20, then 20 up to Z-30; 0.2 mm (U0.4) are left in X and 0.1 in Z.
const std::string kLines = "N10 G0 X20.\nG1 Z-10. F.1\nX30. Z-20.\nX40.\nZ-30.\nN20 X52.\n";

TEST(TurningCycles, RoughingLeavesTheAllowanceAndNoMore) {
  for (const std::string cycle : {"G71 U3. R.5\nG71 P10 Q20 U.4 W.1 F.2\n", "G71 P10 Q20 U.4 W.1 D3. F.2\n",
                                  "G71 P10 Q20 U.4 W.1 D3000 F.2\n", "G71 U3000 R500\nG71 P10 Q20 U400 W100 F.2\n"}) {
    const auto reading = turned("G0 X52. Z2.\n" + cycle + kLines);
    ASSERT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
    EXPECT_NEAR(radius_left_at(reading.moves, -5.0), 10.2, 1e-9) << cycle;
    EXPECT_NEAR(radius_left_at(reading.moves, -14.9), 12.7, 1e-9) << cycle;  // the cone lies 0.1 further out in Z
    EXPECT_NEAR(radius_left_at(reading.moves, -25.0), 20.2, 1e-9) << cycle;
    EXPECT_NEAR(reading.moves.end.back()[0], 26.0, 1e-9) << "back to the start";
    EXPECT_NEAR(reading.moves.end.back()[2], 2.0, 1e-9);
  }
}

TEST(TurningCycles, NoPassOfRoughingIsDeeperThanItsStep) {
  const auto reading = turned("G0 X52. Z2.\nG71 U3. R.5\nG71 P10 Q20 U.4 W.1 F.2\n" + kLines);
  Values levels;
  for (std::size_t i = 0; i < reading.moves.size(); ++i) {
    const AxisVector &a = reading.moves.begin_of(i), &b = reading.moves.end[i];
    if (reading.moves.kind[i] == MoveKind::feed && a[0] == b[0] && b[2] < a[2]) levels.push_back(b[0]);
  }
  ASSERT_GT(levels.size(), 4u);
  EXPECT_NEAR(levels.front(), 26.2 - 3.0, 1e-9) << "the first pass lies a step below the start";
  for (std::size_t i = 1; i < levels.size() && levels[i] < levels[i - 1]; ++i)
    EXPECT_LE(levels[i - 1] - levels[i], 3.0 + 1e-9);
}

TEST(TurningCycles, FinishingFollowsTheLinesWithTheirOwnFeeds) {
  const auto reading = turned("G0 X52. Z2.\nG71 U3. R.5\nG71 P10 Q20 U.4 W.1 F.2\n" + kLines + "G70 P10 Q20\n");
  ASSERT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_NEAR(radius_left_at(reading.moves, -5.0), 10.0, 1e-9);
  EXPECT_NEAR(radius_left_at(reading.moves, -15.0), 12.5, 1e-9);
  for (std::size_t i = 0; i < reading.moves.size(); ++i) {
    if (reading.moves.kind[i] != MoveKind::feed || reading.moves.line[i] != 11) continue;
    EXPECT_NEAR(reading.moves.feed[i], 0.1 * 1000 / 60, 1e-9);
  }
}

TEST(TurningCycles, TheLinesBeforeCountForG70) {
  const auto reading = turned(
      "G0 X52. Z2.\nG73 U0 W0 R1\nG73 P10 Q20 F.2\nN10 G0 X20.\nN20 G1 Z-10.\nG70 P10 Q20\nG0 X60.\n"
      "G73 P10 Q20 F.2\nN10 G0 X30.\nN20 G1 Z-10.\n");
  ASSERT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_NEAR(radius_left_at(reading.moves, -5.0), 10.0, 1e-9);
  EXPECT_EQ(codes(turned("G70 P1 Q2\n")), (Codes{"lathe-contour-lines@2:5"}));
}

TEST(TurningCycles, FacingLeavesTheAllowanceToo) {
  // A step: radius 10 up to Z-5, then the face at Z-5 out to 25. G72 reads it from the outside in.
  const auto reading = turned("G0 X52. Z2.\nG72 W1. R.5\nG72 P30 Q40 U.2 W.1 F.2\nN30 G0 Z-5.\nG1 X20.\nN40 Z1.\n");
  ASSERT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  double deepest = 0.0;
  for (std::size_t i = 0; i < reading.moves.size(); ++i) {
    if (reading.moves.kind[i] == MoveKind::feed) deepest = std::min(deepest, reading.moves.end[i][2]);
  }
  EXPECT_NEAR(deepest, -4.9, 1e-9);
}

TEST(TurningCycles, RepeatingShiftsThePatternTowardsTheLines) {
  const auto reading = turned("G0 X52. Z2.\nG73 U5. W2. R3\nG73 P10 Q20 U.4 W.1 F.2\nN10 G0 X20. Z0\nN20 G1 Z-10.\n");
  ASSERT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  Values radii;
  for (std::size_t i = 0; i < reading.moves.size(); ++i) {
    if (reading.moves.kind[i] == MoveKind::feed) radii.push_back(std::round(reading.moves.end[i][0] * 1e9) / 1e9);
  }
  EXPECT_EQ(radii, (Values{15.2, 12.7, 10.2}));
}

TEST(TurningCycles, ThreadsGoDeeperByEqualAreas) {
  // Height 0.92, first cut 0.3: depths 0.3·√n down to 0.87 (R0.05 is left), then twice at 0.92; X28.16 is the root.
  const auto reading = turned("G0 X32. Z5.\nG76 P020060 Q100 R0.05\nG76 X28.16 Z-18. P920 Q300 F1.5\n");
  ASSERT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  Values radii;
  for (std::size_t i = 0; i < reading.moves.size(); ++i) {
    if (reading.moves.kind[i] == MoveKind::feed) radii.push_back(reading.moves.end[i][0]);
  }
  ASSERT_GE(radii.size(), 4u);
  EXPECT_NEAR(radii[0], 14.08 + 0.92 - 0.3, 1e-9);
  EXPECT_NEAR(radii[1], 14.08 + 0.92 - 0.3 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(radii[radii.size() - 3], 14.08 + 0.05, 1e-9);
  EXPECT_NEAR(radii[radii.size() - 2], 14.08, 1e-9);
  EXPECT_NEAR(radii.back(), 14.08, 1e-9);
  const auto one = turned("G0 X32. Z5.\nG76 X28.16 Z-18. K.92 D.3 F1.5\n");
  EXPECT_FALSE(one.refused) << testing::PrintToString(codes(one));
}

TEST(TurningCycles, GroovesAreCutInSteps) {
  const auto reading = turned("G0 X40. Z-10.\nG75 R.5\nG75 X30. Z-14. P2000 Q2000 F.1\n");
  ASSERT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  Values bottoms;
  for (std::size_t i = 0; i < reading.moves.size(); ++i) {
    if (reading.moves.kind[i] == MoveKind::feed && reading.moves.end[i][0] == 15.0)
      bottoms.push_back(reading.moves.end[i][2]);
  }
  EXPECT_EQ(bottoms, (Values{-10, -12, -14}));
  const auto drilled = turned("G0 X0. Z2.\nG74 R1.\nG74 Z-10. Q3000 F.1\n");
  const Values z = ends(drilled, 2);
  EXPECT_EQ(*std::min_element(z.begin(), z.end()), -10.0);
  EXPECT_EQ(z.back(), 2.0);
}

TEST(TurningCycles, CornersOfTheLinesAreMade) {
  const auto reading =
      turned("G0 X52. Z2.\nG73 R1\nG73 P10 Q20 F.2\nN10 G0 X20.\nG1 Z-10. R2.\nX30. ,C1.\nN20 Z-20.\n");
  ASSERT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  ASSERT_EQ(reading.moves.arcs.size(), 1u);
  EXPECT_NEAR(std::fabs(reading.moves.arcs[0].sweep), 1.5707963267948966, 1e-9);
  EXPECT_NEAR(radius_left_at(reading.moves, -10.5), 14.5, 1e-9);
}

// What is left of a face does not hang on a micrometre of the wall behind it.
TEST(LinuxcncRoughing, AStraightWallIsRoughedAsASlopedOne) {
  const auto rows = [](const std::string& wall, const std::string& cycle) {
    const auto reading =
        read_program("G54 G18 G21 F400\nm3 s100\no100 sub\n" + wall + "o100 endsub\n" + cycle + "m30\n");
    EXPECT_FALSE(reading.refused) << wall << testing::PrintToString(codes(reading));
    return static_cast<double>(std::count(reading.moves.kind.begin(), reading.moves.kind.end(), MoveKind::feed));
  };
  for (const char* cycle : {"G72 Q100 X50 Z0 I3 R0.1\n", "G72.1 Q100 X50 Z0 I3 R0.1\n"}) {
    const auto straight = rows("g1 x50 z-40\nx100 z-40\n", cycle);
    EXPECT_GT(straight, 10) << cycle;
    for (const char* z : {"-39.999", "-40.001", "-39.9999"})
      EXPECT_NEAR(rows(std::string("g1 x50 z-40\nx100 z") + z + "\n", cycle), straight, 4) << cycle << z;
  }
  for (const char* cycle : {"G71 Q100 X50 Z0 I3 R0.1\n"}) {
    const auto straight = rows("g1 x20 z0\nx20 z-40\n", cycle);
    EXPECT_GT(straight, 8) << cycle;
    for (const char* x : {"20.001", "19.999"})
      EXPECT_NEAR(rows(std::string("g1 x20 z0\nx") + x + " z-40\n", cycle), straight, 4) << cycle << x;
  }
}

}  // namespace
}  // namespace toolpace::nc
