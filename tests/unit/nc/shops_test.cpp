/// Programs as the shops write them: what finds their dialect, what senders and printers add, text of all kinds.

#include "reading_test_support.h"

namespace toolpace::nc {
namespace {

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

TEST(WorkOffsets, FurtherSystemsHaveRoomInEveryDialect) {
  const auto reading = read_program("G21 G90\nG54.1 P300\nG0 X1\nM30\n", {.work_offsets = {{309, {10}}}}, "a.tap");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading), (Values{11}));
  EXPECT_EQ(ends(read_program("G21 G90\nG0 X1\nM2\n", {.work_offsets = {{309, {10}}}})), (Values{1}));
  EXPECT_TRUE(read_program("G0 X#9000\nM2\n").refused) << "a program's own numbers end before";
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

TEST(Foreign, OtherLanguagesAreNamedWithTheirLine) {
  struct Case {
    const char* text;
    const char* name;
    std::size_t line;
  };
  const Case cases[] = {{"0 BEGIN PGM X MM\n1 TOOL CALL 1 Z S500\n", "Heidenhain", 1},
                        {"%TEST G71 *\nN10 G30 G17 X+0*\n", "Heidenhain", 1},
                        {"N10 G17 G54\nN20 T=\"MILL\"\n", "Siemens", 2},
                        {"G0 X1\nCYCLE81(10,0,2,-20)\n", "Siemens", 2},
                        {"G90\nG2 X10 Y10 CR=5 F100\n", "Siemens", 2},
                        {"G0 X1\nCALL O200\n", "Okuma", 2},
                        {"PARTNO BLOCK\nGOTO/1,2,3\n", "APT", 1},
                        {"G04 layer*\n%FSLAX24Y24*%\n", "Gerber", 2},
                        {"M48\nMETRIC,TZ\nT1C0.8\n", "Excellon", 2}};
  for (const Case& c : cases) {
    const auto reading = read_text(c.text, "a.nc", {});
    ASSERT_FALSE(reading.has_value()) << c.text;
    EXPECT_EQ(reading.error().code, std::string("language-unsupported"));
    EXPECT_NE(reading.error().message.find(c.name), std::string::npos) << reading.error().message;
    EXPECT_EQ(reading.error().where.line, c.line);
    EXPECT_NE(reading.error().remedy.find("Fanuc"), std::string::npos);
  }
}

TEST(Foreign, CommentsSpeakNoOtherLanguage) {
  const auto reading =
      read_program("(TOOL CALL 5, CYCLE8 CR=2)\nN5(CYCLE81 OF OLD)\nG21 G0 X1 ; MCALL CYCLE81(1)\nM2\n");
  EXPECT_FALSE(reading.refused);
  EXPECT_FALSE(read_text("G0 X1\nCALL O200\n", "a.nc", {.dialect = Dialect::fanuc})->moves.empty());
}

TEST(Senders, MacrosAndBadNumbersOfPrintersMoveNothing) {
  const auto sender = read_program("%msg Start\n%X0=posx,Y0=posy\nG21 G90\nG0 X1\n%wait\nG0 X2\n", {}, "a.nc");
  EXPECT_FALSE(sender.refused) << testing::PrintToString(codes(sender));
  EXPECT_EQ(ends(sender), (Values{1, 2}));
  const auto printer =
      read_as(Dialect::marlin, "M115 U3.11.0\n_LINE_PURGE\n@pause\nG380 S2 Z30 F300\nM620 S0A\nG1 X1\nM900 K0.05\n");
  EXPECT_FALSE(printer.refused) << testing::PrintToString(codes(printer));
  EXPECT_EQ(ends(printer), (Values{1}));
}

TEST(Percent, MayEndTheLastBlock) {
  const auto reading = read_program("G21 G90 G0 X1\nG1 X2 F100\nM30%\n", {}, "a.nc");
  EXPECT_TRUE(reading.diagnostics.empty()) << testing::PrintToString(codes(reading));
}

// About (10, 10) both ends lie 10 away; 10 beside the start they would not.
TEST(UnmarkedText, CentresThatFitAsPlacesAloneAreReadSo) {
  const std::string text = "G21 G90 G17\nG0 X20 Y10\nG3 X10 Y20 I10 J10 F100\nX0 Y10 I10 J10\nM30\n";
  const auto reading = read_program(text, {}, "a.tap");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(codes(reading), (Codes{"arc-centre-absolute@3:12"}));
  ASSERT_EQ(reading.moves.arcs.size(), 2u);
  EXPECT_NEAR(reading.moves.arcs[1].centre.x(), 10.0, 1e-12);
  EXPECT_TRUE(has_code(read_as(Dialect::fanuc, text), "arc-radius-differs")) << "Fanuc's centres are distances";
  EXPECT_TRUE(read_as(Dialect::linuxcnc, text).refused);
}

TEST(UnmarkedText, AxesWithoutAMotionCodeMoveByG0WithAWarning) {
  const auto reading = read_program("G21 G90\nX5\nG1 X6 F100\nG80\nX7\nM30\n", {}, "a.tap");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading), (Values{5, 6, 7}));
  EXPECT_EQ(reading.moves.kind,
            (std::vector<MoveKind>{MoveKind::rapid, MoveKind::feed, MoveKind::feed, MoveKind::end}));
  EXPECT_TRUE(has_code(reading, "axes-without-motion"));
  EXPECT_TRUE(read_program("G21 G90\nX5\nM2\n").refused);
}

TEST(UnmarkedText, CodesOfOtherDialectsKeepTheirMeaning) {
  const auto reading = read_program("G21 G90\nG0 X10 Y10\nG31 Z-100 F500\nG92 Z0\nG0 Z3\nM30\n", {}, "a.tap");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(reading.moves.kind.at(1), MoveKind::probe);
  EXPECT_EQ(ends(reading, 2), (Values{0, -100, -97}));
}

TEST(Dialects, PocketsPatternsAndHeadersTellHaasAndMach3) {
  EXPECT_EQ(read_program("O9\nG54 G0 X0 Y0\nG12 I1.5 F10. Z-1.2 D01\nM30\n", {}, "a.nc").dialect, Dialect::haas);
  EXPECT_EQ(read_program("O9\nG81 Z-1. R.1 F9. L0\nG70 I5. J15. L12\nM30\n", {}, "a.nc").dialect, Dialect::haas);
  EXPECT_EQ(read_program("G0G21G17G90\nG71G91.1\nT1M6\nG0 X1\nM30\n", {}, "a.tap").dialect, Dialect::mach3);
}

TEST(Dialects, SystemBOfLathesIsFoundByItsCodes) {
  const auto reading = read_program(
      "O10\nG21 G40 G90 G95\nG92 S2500\nT0101\nG97 S500 M4\nG0 X50. Z2.\nG78 X19. Z-10. F1.5\nM30\n", {}, "a.nc");
  EXPECT_EQ(reading.dialect, Dialect::fanuc_lathe_b);
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(read_program("O1\nT0101\nG50 S2000\nG92 X19. Z-10. F1.5\nM30\n").dialect, Dialect::fanuc_lathe);
}

}  // namespace
}  // namespace toolpace::nc
