/// Programs as LinuxCNC reads them, where its source decides.

#include <algorithm>

#include "reading_test_support.h"

namespace toolpace::nc {
namespace {

// G38.2 to −0.1 in writes −0.1 into #5063; G0 X#5063 is −2.54 mm.
TEST(Linuxcnc, TheResultOfAProbeIsInTheProgramsUnits) {
  const auto reading = read_program("G20 G90 F10\nG0 Z0\nG38.2 Z-0.1\nG0 Z0.5\nG0 X#5063\nM2\n");
  EXPECT_FALSE(reading.refused);
  EXPECT_NEAR(ends(reading).back(), -2.54, 1e-9);
}

// Half the chord is 100, R 100.0009: the centre lies √(100.0009² − 100²) = 0.424266 mm beside the chord.
TEST(Linuxcnc, AnArcNearASemicircleIsNotMadeOne) {
  const auto reading = read_program("G21 G90 G17\nG0 X0 Y0\nG2 X200 Y0 R100.0009 F500\nM2\n");
  ASSERT_EQ(reading.moves.arcs.size(), 1u);
  EXPECT_NEAR(std::fabs(reading.moves.arcs[0].centre.y()), std::sqrt(100.0009 * 100.0009 - 1e4), 1e-9);
}

TEST(Linuxcnc, AnAbortCommentEndsTheProgramThere) {
  const auto reading = read_program("G21 G90\nG0 X1\n(abort, no tool)\nG0 X99\nthis is not read\n");
  EXPECT_TRUE(reading.refused);
  EXPECT_EQ(codes(reading), (Codes{"program-abort@3:1"}));
  EXPECT_EQ(ends(reading), (Values{1}));
  EXPECT_NE(reading.diagnostics[0].message.find("no tool"), std::string::npos);
}

// F5 under G93 is 12 s, F0.05 is 20 min a block: no feed is raised to a least one.
TEST(Linuxcnc, InverseTimeHasNoLeastFeed) {
  const auto rotary = read_program("G21 G93\nG1 A178.639 F5\nM2\n");
  EXPECT_NEAR(rotary.moves.feed.at(0) * 180.0 / 3.14159265358979323846, 178.639 * 5 / 60, 1e-9);
  const auto slow = read_program("G21 G93 G1 X1 F0.05\nM2\n");
  EXPECT_NEAR(slow.moves.feed.at(0), 0.05 / 60, 1e-15);
}

TEST(Linuxcnc, DiametersHoldForTheDepthOfCyclesToo) {
  const auto reading = read_program("G21 G7 G19 G94 F100\nG0 X40\nG81 X6 Y1 Z1 R9\nG80\nM2\n");
  const Values x = ends(reading);
  EXPECT_EQ(*std::min_element(x.begin(), x.end()), 3.0);
  EXPECT_EQ(x.front(), 20.0);
  EXPECT_NE(std::find(x.begin(), x.end(), 9.0), x.end()) << "R stays what it is";
}

// |5.027 − 5.003| = 0.024 mm ≤ 2√2·0.01; |12.7508 − 12.7| = 0.0508 mm ≤ 2√2·0.001 in; 0.05 mm of 10 mm is neither.
TEST(ArcTolerance, IsWhatLinuxcncsSourceHas) {
  EXPECT_FALSE(read_program("G21 G90\nG3 X0 Y10.03 I0 J5.003 F100\nM2\n").refused);
  EXPECT_FALSE(read_program("G20 G90\nG3 X0 Y1.002 I0 J.5 F10\nM2\n").refused);
  EXPECT_FALSE(read_program("G21 G90\nG3 X.006 Y0 I.003 J0 F10\nM2\n").refused);
  EXPECT_TRUE(read_program("G21 G90\nG2 X20.05 Y0 I10 J0 F10\nM2\n").refused);
  EXPECT_TRUE(read_as(Dialect::grbl, "G21 G90\nG3 X0 Y10.03 I0 J5.003 F100\nM2\n").refused);
}

TEST(ArcTolerance, TheWorstMendedArcIsToldOnce) {
  const std::string text = "G21 G90\nG3 X0 Y10.02 I0 J5 F100\nG0 X0 Y0\nG3 X0 Y10.026 I0 J5 F100\nM2\n";
  const auto reading = read_program(text);
  EXPECT_FALSE(reading.refused);
  ASSERT_EQ(codes(reading), (Codes{"arc-mended@4:0"}));
  EXPECT_NE(reading.diagnostics[0].message.find("0.0260 mm"), std::string::npos);
  EXPECT_NE(reading.diagnostics[0].message.find("2 arcs"), std::string::npos);
  EXPECT_TRUE(read_program(text, {.arc_tolerance = 0.025}).refused);
  EXPECT_FALSE(read_program(text, {.arc_tolerance = 0.0261}).refused);
}

TEST(Linuxcnc, WhatItsSourceReadsIsRead) {
  EXPECT_FALSE(read_program("#5599=0\nG0 X1\nM2\n").refused);
  EXPECT_EQ(ends(read_program("G0 X EXISTS[#99999]\nG0 Y EXISTS[#1]\nM2\n")), (Values{0, 0}));
  const auto call = read_program("o<x> sub\nG0 X#1 Y#2\no<x> endsub\no<x> call (a) [1] (why) [2] (so)\nM2\n");
  EXPECT_EQ(ends(call, 1), (Values{2}));
}

TEST(Linuxcnc, TheWordOfASpindleLeavesTheFirstOneAlone) {
  const auto reading =
      read_program("G21 G90 F100\nM3 S100\nM3 $-1 S100\nM3 $1 S500\nG95 F1\nG1 X5\nG33 Z1 K1 $1\nM5 $0\nM2\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_NEAR(reading.moves.feed.at(0), 100.0 / 60, 1e-12) << "G95 counts the first one's turns";
  EXPECT_NEAR(reading.moves.feed.at(1), 500.0 / 60, 1e-12);
  EXPECT_EQ(codes(read_program("G0 X1 $1\nM2\n")), (Codes{"word-unused@1:7"}));
  EXPECT_EQ(codes(read_program("M3 $9 S1\nM2\n")), (Codes{"spindle-number@1:4"}));
}

TEST(Linuxcnc, ProbingNowhereIsAnErrorOnlyWhereContactIsWanted) {
  EXPECT_FALSE(read_program("G21 F100\nG38.3 Z0\nG38.5 Z0\nM2\n").refused);
  EXPECT_TRUE(read_program("G21 F100\nG38.2 Z0\nM2\n").refused);
  EXPECT_TRUE(read_program("G21 F100\nG38.4 Z0\nM2\n").refused);
}

TEST(Linuxcnc, NothingBehindTheSecondPercentIsASubProgram) {
  const auto reading = read_program("%\nG21\nG0 X1\no2 call\n%\no2 sub\nG0 Z3\no2 endsub\n");
  EXPECT_EQ(codes(reading), (Codes{"sub-program-unknown@4:2"}));
}

// A probe goes to its end: G38.2 touches there, G38.3 has touched nothing.
TEST(Linuxcnc, AProbeTellsWhetherItTouched) {
  const auto reading =
      read_program("G21 F100\n#5070=1\nG38.3 Z-1\nG0 X#5070\nG38.2 Z-2\nG0 Y#5070\nG38.5 Z0\nG0 X[#5070+5]\nM2\n");
  EXPECT_EQ(ends(reading, 0), (Values{0, 0, 0, 0, 0, 5}));
  EXPECT_EQ(ends(reading, 1), (Values{0, 0, 0, 1, 1, 1}));
}

}  // namespace
}  // namespace toolpace::nc
