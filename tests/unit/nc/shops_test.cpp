/// Programs as the shops write them: what each controller reads in them, in small ones.

#include <algorithm>

#include "reading_test_support.h"

namespace toolpace::nc {
namespace {

bool has_code(const Reading& reading, const std::string& code) {
  return std::any_of(reading.diagnostics.begin(), reading.diagnostics.end(),
                     [&](const Diagnostic& d) { return d.code == code; });
}

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

TEST(Percent, WhatStandsBehindALoneOneIsTold) {
  const std::string text = "G21 G90\nG1 X10 F100\n%\nG1 X20\nM2\n";
  for (const auto& reading : {read_program(text), read_program(text, {}, "test.nc"), read_as(Dialect::grbl, text)}) {
    ASSERT_EQ(codes(reading), (Codes{"text-behind-percent@3:1"}));
    EXPECT_NE(reading.diagnostics[0].message.find("lines 4 to 5"), std::string::npos);
    EXPECT_EQ(ends(reading), (Values{10}));
  }
}

TEST(Percent, AHeaderBeforeTheFirstOneIsNoProgram) {
  for (const char* header : {"(NAME)\nO1234\n", "(NAME)\n", "\n:12 (X)\n"}) {
    const auto reading = read_program(std::string(header) + "%\nG21 G90\nG1 X10 F100\nM30\n%\n", {}, "a.nc");
    EXPECT_FALSE(reading.refused);
    EXPECT_EQ(ends(reading), (Values{10})) << header;
  }
}

TEST(Ends, AMissingOneIsAWarningWhereTheTextIsNotLinuxcncs) {
  const std::string text = "G21 G90\nG0 X1\nG1 X10 F100\n";
  const auto reading = read_program(text, {}, "a.nc");
  EXPECT_FALSE(reading.refused);
  EXPECT_EQ(codes(reading), (Codes{"program-without-end@3:1"}));
  EXPECT_EQ(reading.moves.kind.back(), MoveKind::end);
  EXPECT_TRUE(read_as(Dialect::linuxcnc, text).refused);
  EXPECT_TRUE(read_program(text, {}, "a.ngc").refused);
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

TEST(Fanuc, CyclesReturnToTheInitialLevelFromTheStart) {
  const auto reading = read_program("%\nO1\nG21 G90 G17\nG0 X0 Y0 Z50.\nG81 X10. Z-5. R2. F100\nX20.\nG80\nM30\n%\n");
  // Z50 at the start, over the hole, R, bottom, back to 50; over the next one, R, bottom, 50.
  EXPECT_EQ(ends(reading, 2), (Values{50, 50, 2, -5, 50, 50, 2, -5, 50}));
}

TEST(Fanuc, CyclesDwellInMilliseconds) {
  const auto reading = read_program("O1\nG21 G90\nG82 X1. Z-1. R1. P500 F100\nM30\n");
  EXPECT_EQ(reading.moves.dwells, (Values{0.5}));
}

TEST(Fanuc, M99WithPInAProgramItselfGoesOnThere) {
  EXPECT_EQ(ends(read_program("O1\nG21 G90\nG0 X1.\nM99 P9\nG0 X50.\nN9 G0 X20.\nM30\n")), (Values{1, 20}));
  EXPECT_EQ(codes(read_program("O1\nM99 P9\nM30\n")), (Codes{"line-number-unknown@2:5"}));
}

TEST(Fanuc, WordsOfMacrosMayBeCutOff) {
  EXPECT_EQ(ends(read_program("O5\nG21 G90\n#1=0\nWH[#1LT3]DO1\n#1=#1+1\nEN1\nG0 X#1\nM30\n")), (Values{3}));
  EXPECT_EQ(ends(read_program("O5\nG21\nIF[1EQ1]GO9\nG0 X5\nN9 G0 X7\nM30\n")), (Values{7}));
}

TEST(Fanuc, AMotionCodeMayStandBesideGoingHome) {
  const auto reading = read_program("O1\nG21\nG0 X5. Z5.\nG1 G91 G28 Z0. F100\nG90 X1.\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(reading.moves.kind.at(3), MoveKind::feed);
  EXPECT_EQ(ends(reading, 2), (Values{5, 5, 0, 0}));
}

TEST(Fanuc, FurtherCoordinateSystemsHaveNumbers) {
  const auto reading = read_program(
      "O8\nG21 G90\nG10 L20 P3 X100. Y5.\n#14981=7\nG54.1 P3\nG0 X1. Y1.\nG54.1 P50\nG0 X2.\nG54\nG0 X1.\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  // P50 begins at #14001 + 49·20 = #14981.
  EXPECT_EQ(ends(reading), (Values{101, 9, 1}));
  EXPECT_EQ(reading.modal.at(6)->work_offset(), "G54.1 P3");
  EXPECT_EQ(codes(read_program("O8\nG54.1\nM30\n")), (Codes{"system-number@2:1"}));
}

TEST(Corners, AChamferBeginsAndEndsAtItsLengthFromTheCorner) {
  const auto reading = read_program("O9\nG21 G90 G0 X0 Y0\nG1 X10. ,C2. F100\nY10. F200\nM30\n");
  EXPECT_EQ(ends(reading, 0), (Values{0, 8, 10, 10}));
  EXPECT_EQ(ends(reading, 1), (Values{0, 0, 2, 10}));
  EXPECT_EQ(reading.moves.line, (std::vector<std::uint32_t>{2, 3, 3, 4, 5}));
  EXPECT_NEAR(reading.moves.feed.at(2), 100.0 / 60, 1e-12);
  EXPECT_NEAR(reading.moves.feed.at(3), 200.0 / 60, 1e-12);
}

TEST(Corners, ARoundingIsTangentToLinesAndArcs) {
  const auto lines = read_program("O9\nG21 G90 G0 X0 Y0\nG1 X10. ,R3. F100\nY10. ,R1.\nX0\nM30\n");
  EXPECT_EQ(ends(lines, 0), (Values{0, 7, 10, 10, 9, 0}));
  EXPECT_EQ(ends(lines, 1), (Values{0, 0, 3, 9, 10, 10}));
  ASSERT_EQ(lines.moves.arcs.size(), 2u);
  EXPECT_NEAR(lines.moves.arcs[0].sweep, 1.5707963267948966, 1e-12);
  EXPECT_NEAR(lines.moves.arcs[0].centre.x(), 7.0, 1e-12);
  // A line to (10, 0), then an arc about (10, 10) down from (10, 0)… to (20, 10): tangent already, so no corner is made.
  const auto smooth = read_program("O9\nG21 G90 G0 X0 Y0\nG1 X10. ,R3. F100\nG3 X20. Y10. J10.\nM30\n");
  EXPECT_EQ(ends(smooth, 0), (Values{0, 10, 20}));
}

TEST(Corners, WhatMakesNoneIsTold) {
  EXPECT_TRUE(has_code(read_program("O9\nG1 X10. ,C20. F100\nY10.\nM30\n"), "corner-too-large"));
  EXPECT_TRUE(has_code(read_program("O9\nG1 X10. ,C2. F100\nZ10.\nM30\n"), "corner-off-plane"));
  EXPECT_TRUE(has_code(read_program("O9\nG1 X10. ,Q2. F100\nM30\n"), "corner-word"));
  const auto last = read_program("O9\nG21 G1 X10. ,C2. F100\nM30\n");
  EXPECT_FALSE(last.refused);
  EXPECT_EQ(codes(last), (Codes{"corner-without-move@3:1"}));
  EXPECT_EQ(ends(last), (Values{10}));
}

TEST(Haas, ItsCodesMakeTheDialect) {
  const auto reading = read_program("G21 G90\nG154 P2\nG187 P3\nG1 X1. ,R0.5 F100\nY2.\nM30\n", {}, "a.nc");
  EXPECT_EQ(reading.dialect, Dialect::haas);
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(reading.modal.at(4)->work_offset(), "G54.1 P2");
}

TEST(Mach3, ItsHeaderMakesTheDialect) {
  const auto reading = read_program("G0 G49 G40.1 G17 G80 G50 G90\nG70\nG0 X1\nG71\nX1\nM30\n", {}, "a.tap");
  EXPECT_EQ(reading.dialect, Dialect::mach3);
  EXPECT_EQ(ends(reading), (Values{0, 25.4, 1}));
}

TEST(Grbl, WhatItTakesIsRead) {
  EXPECT_EQ(ends(read_program("G21 G90\n? ; status\nG0 X1 ?\n!G0 X2~\nM2\n", {}, "a.nc")), (Values{1, 2}));
  const auto centre = read_program("G21 G90 G17\nG0 X10 Y0\nG2 X-10 Y0 I-10 J0 K0 F100\nM2\n", {}, "a.nc");
  EXPECT_EQ(centre.dialect, Dialect::grbl);
  EXPECT_EQ(ends(centre), (Values{10, -10}));
  const auto machine = read_program("G21 G90\nG91\nG53 G0 Z-5\nM2\n", {}, "a.nc");
  EXPECT_EQ(ends(machine, 2), (Values{-5}));
  EXPECT_TRUE(read_as(Dialect::linuxcnc, "G2 X-10 I-5 K0 F100\nM2\n").refused);
}

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

TEST(Dialects, TheReasonsAreTold) {
  const auto lathe = read_program("G21\nT0101\nG50 S1000\nG0 X10. Z1.\nM30\n", {}, "a.nc");
  EXPECT_EQ(lathe.dialect, Dialect::fanuc_lathe);
  ASSERT_FALSE(lathe.dialect_reasons.empty());
  EXPECT_NE(lathe.dialect_reasons[0].find("line 2"), std::string::npos);
  EXPECT_TRUE(read_as(Dialect::grbl, "G0 X1\n").dialect_reasons.empty());
}

TEST(Dialects, AMillIsNoLathe) {
  EXPECT_EQ(read_program("O1\nT0101 M6\nG0 X1. Y1.\nG1 Z-1. F100\nM30\n").dialect, Dialect::fanuc);
  EXPECT_EQ(read_program("G18 G7\nG0 X1 Z1\nM2\n").dialect, Dialect::linuxcnc);
  EXPECT_EQ(read_program("G54 G18 G21 F400\no100 sub\ng1 x50 z-40\no100 endsub\nG72 Q100 X50 Z0 I3\nM2\n").dialect,
            Dialect::linuxcnc);
}

TEST(Dialects, DoubtIsAWarningThatNamesTheOther) {
  const auto reading = read_program("G21\nT0101\nG97 S1000 M3\nG0 X10. Z1.\nM30\n", {}, "a.nc");
  EXPECT_EQ(reading.dialect, Dialect::fanuc_lathe);
  EXPECT_TRUE(has_code(reading, "dialect-uncertain"));
}

// A text that nothing marks is read as LinuxCNC's, but what means nothing there is a warning.
TEST(UnmarkedText, WhatMeansNothingIsAWarning) {
  const auto reading =
      read_program("G21 G90 G0 X1 Q5\nG91 G28 G0 Z0\nM230 P3\n(a (b) c) G90 G0 X2 N7\nM3 M8 M9\nM30\n", {}, "a.tap");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(reading.dialect, Dialect::linuxcnc);
  EXPECT_TRUE(has_code(reading, "word-unused"));
  EXPECT_TRUE(has_code(reading, "modal-group-twice"));
  EXPECT_EQ(ends(reading).back(), 2.0);
  EXPECT_TRUE(read_program("G21 G90 G0 X1 Q5\nM2\n").refused) << "a .ngc is LinuxCNC's";
}

TEST(Fanuc, TheLastOfWhatComesTwiceCounts) {
  const auto reading = read_program("O1\nG21 G90 G91 G0 X1. X2.\nX2.\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading), (Values{2, 4}));
  EXPECT_TRUE(has_code(reading, "modal-group-twice"));
  EXPECT_TRUE(has_code(reading, "word-twice"));
}

TEST(Fanuc, AMissingSubProgramIsAWarning) {
  const auto reading = read_program("O1\nG21\nG0 X1.\nG65 P9810 X5.\nM98 P77\nX2.\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(codes(reading), (Codes{"sub-program-missing@4:1", "sub-program-missing@5:5"}));
  EXPECT_EQ(ends(reading), (Values{1, 2}));
}

TEST(Fanuc, WhatIsWrittenToAPortIsLeftOut) {
  const auto reading = read_program("O1\nG21\nPOPEN\nDPRNT[X#1[53]*A]\nPCLOS\nG0 X2.\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading), (Values{2}));
}

// G10 L10 P1 R25 makes the length 25 mm, L11 adds its wear; G44 takes it away.
TEST(Fanuc, ToolOffsetsAreSetByG10) {
  const auto reading =
      read_program("O1\nG21 G90\nG10 L10 P1 R25.\nG10 L11 P1 R0.5\nG43 H1\nG0 Z1.\nG49\nG44 H1\nG0 Z1.\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading, 2), (Values{26.5, -24.5}));
}

TEST(Haas, M97CallsLinesOfTheProgram) {
  const auto reading = read_program("O1 (HAAS)\nG21 G91\nM97 P100 L2\nM30\nN100 G0 X1.\nM99\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading), (Values{1, 2}));
}

TEST(Printers, MacrosAndSettingsMoveNothing) {
  const auto reading = read_program(
      "START_PRINT BED_TEMP=60\nM862.3 P \"MK3S\"\nG28 W\nG29\nG10\nG1 X5 Y5\nEXCLUDE_OBJECT_START NAME=a_1\nG11\n"
      "SET_VELOCITY_LIMIT ACCEL=500\nG1 X6 E.5 F600\n",
      {}, "a.gcode");
  EXPECT_EQ(reading.dialect, Dialect::marlin);
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading).back(), 6.0);
  EXPECT_NEAR(reading.moves.feed.at(1), 25.0, 1e-12) << "the feed that printers begin with";
}

TEST(Text, ControlCharactersOfTapesAreBlanks) {
  const auto reading = read_program("\x11%\nO1\nG21 G0\x13 X1.\nM30\n%\n\x1A", {}, "a.nc");
  EXPECT_TRUE(reading.diagnostics.empty()) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(read_program("G21 G0 X1\nM2\n\x1A")), (Values{1}));
}

TEST(Linuxcnc, ProbingNowhereIsAnErrorOnlyWhereContactIsWanted) {
  EXPECT_FALSE(read_program("G21 F100\nG38.3 Z0\nG38.5 Z0\nM2\n").refused);
  EXPECT_TRUE(read_program("G21 F100\nG38.2 Z0\nM2\n").refused);
  EXPECT_TRUE(read_program("G21 F100\nG38.4 Z0\nM2\n").refused);
}

// (10, 30°) and (10, 90°) about the origin; 60° further is 150°.
TEST(Fanuc, PolarCoordinatesAreARadiusAndAnAngle) {
  const auto reading = read_program(
      "O1\nG21 G90 G17\nG0 Z5.\nG16\nG81 X10. Y30. Z-1. R1. F100\nY90.\nG91 Y60.\nG90 G80 G15\nG0 X1. Y2.\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  const Values x = ends(reading, 0), y = ends(reading, 1);
  EXPECT_NEAR(x.at(1), 10 * std::sqrt(0.75), 1e-6);
  EXPECT_NEAR(y.at(1), 5.0, 1e-6);
  EXPECT_NEAR(x[x.size() - 2], -10 * std::sqrt(0.75), 1e-6);
  EXPECT_NEAR(y[y.size() - 2], 5.0, 1e-6);
  EXPECT_EQ(x.back(), 1.0);
  EXPECT_TRUE(has_code(read_program("O1\nG16 G91\nG0 X1.\nM30\n"), "polar-incremental"));
}

TEST(FanucLathe, SystemBHasItsCyclesUnderOtherNumbers) {
  const auto reading =
      read_as(Dialect::fanuc_lathe_b,
              "G21 G90 G94 F100\nG92 S2000\nG97 S1000 M3\nG0 X50. Z2.\nG77 X40. Z-20.\nG91 G0 X2.\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading, 0), (Values{25, 20, 20, 25, 25, 26}));
  EXPECT_NEAR(reading.moves.feed.at(2), 100.0 / 60, 1e-12);
}

TEST(WorkOffsets, ComeFromOutside) {
  const auto reading =
      read_program("G21 G90\nG0 X1\nG55 G0 X1\nM2\n", {.work_offsets = {{1, {10, 20, 30}}, {2, {-5}}}});
  EXPECT_EQ(ends(reading, 0), (Values{11, -4}));
  EXPECT_EQ(ends(reading, 1), (Values{0, 0})) << "the machine stands at its zero";
  EXPECT_EQ(work_system_named("g59.3"), 9);
  EXPECT_EQ(work_system_named("G54.1P7"), 16);
  EXPECT_EQ(work_system_named("G60"), std::nullopt);
  EXPECT_EQ(work_system_named("G54.1P301"), std::nullopt);
}

TEST(Dwells, CountAsTheirDialectAndTheirPointSay) {
  EXPECT_EQ(read_as(Dialect::haas, "G4 P500\nG4 P1.5\nM30\n").moves.dwells, (Values{0.5, 1.5}));
  EXPECT_EQ(read_as(Dialect::fanuc_lathe, "G21\nG0 X4.\nG4 U1.5\nG4 X2.\nM30\n").moves.dwells, (Values{1.5, 2}));
  EXPECT_EQ(read_as(Dialect::marlin, "G4 P500.0\n").moves.dwells, (Values{0.5}));
  EXPECT_EQ(read_as(Dialect::linuxcnc, "G4 P500\nM2\n").moves.dwells, (Values{500}));
  // A text that nothing marks: the shorter of the two is taken, and told.
  const auto unmarked = read_program("G21 G4 P500\nG4 P2\nG4 P500.\nM30\n", {}, "a.nc");
  EXPECT_EQ(unmarked.moves.dwells, (Values{0.5, 2, 500}));
  EXPECT_EQ(codes(unmarked), (Codes{"dwell-uncertain@1:8"}));
}

}  // namespace
}  // namespace toolpace::nc
