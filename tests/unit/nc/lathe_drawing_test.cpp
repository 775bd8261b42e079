/// What drawings say and lathe programs take over: chamfers, roundings, angles of lines, ends of threads.

#include "reading_test_support.h"

namespace toolpace::nc {
namespace {

const std::string kBegin = "G21 G97 S600 M3\n";

Reading read_lathe(const std::string& text) { return read_as(Dialect::fanuc_lathe, kBegin + text); }

TEST(LatheCorners, COfAStraightMoveIsAChamferUnlessTheAxisCHasMoved) {
  const auto reading = read_lathe("G0 X0 Z0\nG1 X20. C2. F.1\nZ-20.\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading, 0), (Values{0, 8, 10, 10}));
  EXPECT_EQ(ends(reading, 2), (Values{0, 0, -2, -20}));
  EXPECT_TRUE(has_code(reading, "lathe-chamfer"));
  const auto axis = read_lathe("G0 X20. Z1. C0\nG98 G1 X10. C90. F100\nZ-20.\nM30\n");
  EXPECT_FALSE(has_code(axis, "lathe-chamfer"));
  EXPECT_NEAR(axis.moves.end.at(1)[5], 1.5707963267948966, 1e-12);
}

TEST(LatheCorners, IAndKAreChamfersTowardsTheOtherAxis) {
  const auto reading = read_lathe("G0 X20. Z0\nG1 Z-20. I3. F.1\nX40. K-2.\nZ-30.\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading, 0), (Values{10, 10, 13, 18, 20, 20}));
  EXPECT_EQ(ends(reading, 2), (Values{0, -17, -20, -20, -22, -30}));
}

// From ∅20 to ∅40 at 150° to +Z: the radius grows by 10, Z falls by 10/tan 30° = 17.320508.
TEST(LatheAngles, OneCoordinateTellsTheOther) {
  for (const char* line : {"X40. ,A150.", "X40. A150.", "Z-37.320508075688775 A150."}) {
    const auto reading = read_lathe(std::string("G0 X20. Z-20.\nG1 ") + line + " F.1\nM30\n");
    EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
    EXPECT_NEAR(reading.moves.end.at(1)[0], 20.0, 1e-9) << line;
    EXPECT_NEAR(reading.moves.end.at(1)[2], -20.0 - 10.0 * std::sqrt(3.0), 1e-9) << line;
  }
  EXPECT_TRUE(has_code(read_lathe("G0 X20. Z0\nG1 X40. ,A180. F.1\nM30\n"), "line-angle"));
}

TEST(LatheAngles, ALineWithItsAngleAloneEndsWhereTheNextOneMeetsIt) {
  const auto reading = read_lathe("G0 X20. Z0\nG1 ,A180. ,C1. F.1\nX40. Z-20. ,A90.\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading, 0), (Values{10, 10, 11, 20}));
  EXPECT_EQ(ends(reading, 2), (Values{0, -19, -20, -20}));
  EXPECT_TRUE(has_code(read_lathe("G0 X20. Z0\nG1 ,A180. F.1\nM30\n"), "line-angle-open"));
  EXPECT_TRUE(has_code(read_lathe("G0 X20. Z0\nG1 ,A180. F.1\nX40. Z-20.\nM30\n"), "line-angle-open"));
  EXPECT_TRUE(has_code(read_lathe("G0 X20. Z0\nG1 ,A180. F.1\nX40. Z-20. ,A180.\nM30\n"), "line-angle"));
}

TEST(LatheAngles, StandInContoursToo) {
  const auto reading = read_lathe(
      "G0 X60. Z2.\nG70 P1 Q2 F.1\nG0 X80.\nM30\nN1 G0 X20.\nG1 Z0\nA180. R2.\nX40. Z-20. A90. C1.\nN2 Z-30.\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  const Values x = ends(reading, 0), z = ends(reading, 2);
  // From the start to X20, Z0, along to the rounding, up to the chamfer, along it, and on to Z−30.
  EXPECT_EQ(Values(x.begin(), x.begin() + 8), (Values{30, 10, 10, 10, 12, 19, 20, 20}));
  EXPECT_EQ(Values(z.begin(), z.begin() + 8), (Values{2, 2, 0, -18, -20, -20, -21, -30}));
  EXPECT_TRUE(has_code(read_lathe("G0 X60. Z2.\nG70 P1 Q2 F.1\nM30\nN1 G0 X20.\nN2 G1 A180.\n"), "line-angle-open"));
}

TEST(Millwork, AnglesCountFromTheFirstAxisOfThePlane) {
  const auto reading = read_program("O1\nG21 G90 G17\nG0 X0 Y0\nG1 X10. ,A45. F100\nM30\n");
  EXPECT_NEAR(reading.moves.end.at(1)[1], 10.0, 1e-9);
}

// r of P011060 is 10: the thread leaves the work over one lead, 2 mm.
TEST(LatheThreads, ArePulledOutAsG76Says) {
  const auto reading = read_lathe("G76 P011060 Q100 R0\nG0 X22. Z5.\nG92 X18. Z-20. F2.\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading, 0), (Values{11, 9, 9, 11, 11, 11}));
  EXPECT_EQ(ends(reading, 2), (Values{5, 5, -18, -20, -20, 5}));
  const auto plain = read_lathe("G0 X22. Z5.\nG92 X18. Z-20. F2.\nM30\n");
  EXPECT_EQ(ends(plain, 2), (Values{5, 5, -20, -20, 5}));
}

TEST(LatheThreads, TakeTheirLeadFromE) {
  const auto line = read_lathe("G0 X20. Z5.\nG32 Z-10. E1.5\nM30\n");
  EXPECT_FALSE(line.refused) << testing::PrintToString(codes(line));
  EXPECT_NEAR(line.moves.feed.at(1), 1.5 * 600 / 60, 1e-12);
  const auto passes = read_lathe("G0 X22. Z5.\nG92 X19. Z-10. E1.5\nX18.\nM30\n");
  EXPECT_NEAR(passes.moves.feed.at(2), 15.0, 1e-12);
  EXPECT_NEAR(passes.moves.feed.at(6), 15.0, 1e-12);
}

}  // namespace
}  // namespace toolpace::nc
