/// Programs of Fanuc's and Haas's mills, in small ones.

#include "reading_test_support.h"

namespace toolpace::nc {
namespace {

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

TEST(Fanuc, SetvnNamesVariables) {
  const auto reading = read_program(
      "O1\nG21\nSETVN 510[TOOL_X,DEPTH]\n#[TOOL_X]=3.\n#511=[#[tool_x]+1.]\nG0 X#[DEPTH]\n#5=1.\nX#[#5+4.]\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading).front(), 4);
  EXPECT_EQ(ends(reading).back(), 1) << "#[…] goes on being a calculated number";
  for (const char* line : {"SETVN", "SETVN 510", "SETVN 510[A", "SETVN 0[A]", "SETVN 199999[A,B]", "SETVN 1.5[A]"}) {
    EXPECT_EQ(codes(read_program("O1\nG21\nG0 X1.\n" + std::string(line) + "\nM30\n")).front().substr(0, 16),
              "setvn-unreadable")
        << line;
  }
}

// 0x1234 = 4660; what is behind the point is left out.
TEST(Fanuc, BinAndBcdGoBetweenNumbersAndTheirDigits) {
  const auto reading = read_program("O1\nG21\n#1=BIN[4660]\nG0 X[#1/100.]\nXBCD[12.7]\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading), (Values{12.34, 18}));
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

// Codes that set something keep their axis words: nothing moves by them.
TEST(Fanuc, SettingsMoveNothing) {
  const auto reading = read_program(
      "O1\nG21 G90\nG0 X1.\nG22 X100. Y100. Z100. I-1. J-1. K-1.\nG23\nG37 Z10.\nG10 L50\nN5130 R10\nG11\nG50.1\n"
      "G05 P10000\nG13.1\nG0 X2.\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading), (Values{1, 2}));
}

TEST(Fanuc, CodesOfTheMachineAreToldAndMoveNothing) {
  const auto reading = read_program("O1\nG21 G90\nG0 X1.\nG325 A1. X50. D2\nG800\nX2.\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading), (Values{1, 2}));
  EXPECT_TRUE(has_code(reading, "g-code-machine"));
  EXPECT_TRUE(read_program("G325 X1\nM2\n").refused) << "LinuxCNC has no such code";
}

TEST(Fanuc, WhatChangesTheGeometryIsRefusedByName) {
  for (const char* code : {"G112", "G12.1", "G7.1 C20.", "G68.2 X0 Y0 Z0", "G6.2", "G45 X1. D1"}) {
    const auto reading = read_program(std::string("O1\nG21\n") + code + "\nM30\n");
    EXPECT_TRUE(has_code(reading, "g-code-unfollowed")) << code;
  }
}

// By way of X5 to the machine's zero, and back by way of it to X9.
TEST(Fanuc, TheWayBackFromTheReferencePointLeadsThroughTheSamePoint) {
  const auto reading = read_program("O1\nG21 G90\nG0 X1.\nG28 X5.\nG29 X9.\nG27 X0\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading), (Values{1, 5, 0, 5, 9, 0}));
}

TEST(Fanuc, WaitingByTheClockEnds) {
  const auto reading = read_program("O1\nG21\n#3001=0\nWHILE[#3001LT5000]DO1\nEND1\n#100100=2.\nG0 X#100100\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading), (Values{2}));
}

TEST(Fanuc, AModalMacroDoesNotCallItself) {
  const auto reading = read_program(
      "O1\nG21 G90\nG66 P6 Z-5.\nX10.\nM98 P7\nX30.\nG67\nX40.\nM30\nO6\nG0 Z5.\nZ#26\nG0 Z5.\nM99\nO7\nX20.\nM99\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading, 0), (Values{10, 10, 10, 10, 20, 20, 20, 20, 30, 30, 30, 30, 40}));
  EXPECT_EQ(ends(reading, 2), (Values{0, 5, -5, 5, 5, 5, -5, 5, 5, 5, -5, 5, 5}));
}

TEST(Fanuc, FixAndFupGoTowardsZeroAndAwayFromIt) {
  EXPECT_EQ(ends(read_program("O1\nG21 G90\nG0 X[FIX[-1.5]]\nX[FUP[-1.5]]\nX[FUP[1.2]]\nM30\n")), (Values{-1, -2, 2}));
  EXPECT_EQ(ends(read_as(Dialect::linuxcnc, "G21 G90\nG0 X[FIX[-1.5]]\nX[FUP[-1.5]]\nM2\n")), (Values{-2, -1}));
}

TEST(Fanuc, ModalCodesCanBeAsked) {
  const auto reading = read_program("O1\nG21 G90 G55\nIF[#4014EQ55]GOTO5\nG0 X1.\nN5 G0 Z#4012\nM30\n");
  EXPECT_EQ(ends(reading, 0), (Values{0}));
  EXPECT_EQ(ends(reading, 2), (Values{55}));
}

TEST(Fanuc, ASlashInABlockDeletesWhatFollows) {
  const std::string text = "O1\nG21 G90\nN10 /2 G0 X5.\nN20 G0 Y1. / X9.\nM30\n";
  EXPECT_EQ(ends(read_program(text)), (Values{5, 9}));
  EXPECT_EQ(ends(read_program(text, {.block_delete = true})), (Values{0}));
}

TEST(Fanuc, ProgramsMayHaveNames) {
  const auto reading = read_program("%\n<HEADER_001>(TEST)\nG21 G90\nG0 X10.\nM30\n%\n", {}, "a.nc");
  EXPECT_EQ(reading.dialect, Dialect::fanuc);
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading), (Values{10}));
}

TEST(Fanuc, ThenMayJump) {
  EXPECT_EQ(ends(read_program("O1\nG21 G90\nIF[1EQ1]THEN GOTO 9\nG0 X1.\nN9 G0 X2.\nM30\n")), (Values{2}));
  EXPECT_EQ(ends(read_program("O1\nG21 G90\nIF[1EQ2]THEN GOTO 9\nGOTO N8\nG0 X1.\nN8 X3.\nN9 X2.\nM30\n")),
            (Values{3, 2}));
  EXPECT_EQ(ends(read_program("O1\nG21 G90\nIF[1EQ1]THEN #1=4.\nG0 X#1\nM30\n")), (Values{4}));
}

TEST(Fanuc, ALongNumberIsAProgramBeforeItIsARepeat) {
  const std::string subs = "M30\nO900003\nG0 X1.\nM99\nO3\nG91 G0 Y1.\nG90\nM99\n";
  EXPECT_EQ(ends(read_program("O1\nG21 G90\nM98 P900003\n" + subs)), (Values{1}));
  EXPECT_EQ(ends(read_program("O1\nG21 G90\nM98 P20003\n" + subs), 1), (Values{1, 2}));
}

TEST(Fanuc, SubProgramsMayBeCalledByName) {
  const auto reading = read_program(
      "%\n<MAIN>\nG21 G90\nM98 <PART_A> L2\nG65 <MOVE> X7.\nM98 <GONE>\nM30\n<PART_A>\nG91 G0 X1.\nG90\nM99\n<MOVE>\n"
      "G0 X#24\nM99\n%\n",
      {}, "a.nc");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading), (Values{1, 2, 7}));
  EXPECT_EQ(codes(reading), (Codes{"sub-program-missing@6:1"}));
}

// 12500 least increments of 0.001 mm; under G20 they are 0.0001 in.
TEST(IntegerWords, AllLargeAndWithoutAPointAreLeastIncrements) {
  const std::string text = "O1\nG21 G90 G17\nG0 X12500 Y-20000\nG1 Z-5000 F200\nG2 X22500 Y-10000 R10000\nM30\n";
  const auto reading = read_program(text);
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading), (Values{12.5, 12.5, 22.5}));
  EXPECT_NEAR(reading.moves.feed.at(1), 200.0 / 60, 1e-12) << "feeds are what they are";
  EXPECT_EQ(codes(reading), (Codes{"integers-are-increments@3:0"}));
  EXPECT_EQ(ends(read_program(text, {.integers = IntegerWords::lengths})), (Values{12500, 12500, 22500}));
  EXPECT_EQ(ends(read_program("O1\nG20\nG0 X15000\nM30\n")), (Values{38.1}));
}

TEST(IntegerWords, RepeatsAreNoCoordinates) {
  const auto reading = read_program("O1\nG21 G90\nG0 X0. Y0. Z5.\nG91 G99 G81 X1. Z-1. R-1. K3 F100\nG80\nM30\n");
  EXPECT_TRUE(reading.diagnostics.empty()) << testing::PrintToString(codes(reading));
  const auto counted = read_program("O1\nG21 G90\nG0 Z5000\nG91 G99 G81 X1000 Z-1000 R-1000 K3 F100\nG80\nM30\n");
  EXPECT_FALSE(counted.refused) << testing::PrintToString(codes(counted));
  EXPECT_EQ(ends(counted).back(), 3.0);
}

TEST(IntegerWords, BesideOthersAreLengthsAndTold) {
  const std::string text = "O1\nG21 G90\nG0 X10 Y2.5\nX0\nM30\n";
  const auto reading = read_program(text);
  EXPECT_EQ(ends(reading), (Values{10, 0}));
  EXPECT_EQ(codes(reading), (Codes{"integers-are-lengths@3:0"}));
  EXPECT_EQ(ends(read_program(text, {.integers = IntegerWords::increments})), (Values{0.01, 0}));
  EXPECT_TRUE(read_program("O1\nG21 G90\nG0 X10. Y0\n#1=5\nZ#1\nM30\n").diagnostics.empty());
  EXPECT_EQ(ends(read_program("O1\nG21\n#1=5\nG0 X#1\nM30\n", {.integers = IntegerWords::increments})), (Values{5}))
      << "variables are numbers";
}

TEST(Haas, WorkOffsetsHaveCodesOfTheirOwn) {
  const auto reading = read_as(Dialect::haas, "G21 G90\nG10 L20 P2 X100.\nG111 G0 X1.\nG154 P2 X2.\nG129\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading), (Values{101, 102}));
  EXPECT_EQ(reading.modal.at(5)->work_offset(), "G54.1 P20");
}

}  // namespace
}  // namespace toolpace::nc
