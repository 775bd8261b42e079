#include "toolpace/nc/dialects/detect.h"

#include <fmt/format.h>

#include <algorithm>

#include "reading_test_support.h"

namespace toolpace::nc {
namespace {

TEST(Dialects, AreRecognisedByWhatOnlyTheyHave) {
  EXPECT_EQ(detect_dialect("G21\nG1 X1 F5\nM2\n").dialect, Dialect::linuxcnc);
  EXPECT_EQ(detect_dialect("%\nO1234 (BRACKET)\nG90 G54\nM30\n%\n").dialect, Dialect::fanuc);
  EXPECT_EQ(detect_dialect("G90\nIF [#1 GT 2] GOTO 10\nM30\n").dialect, Dialect::fanuc);
  EXPECT_EQ(detect_dialect("G90\nG65 P9010 A1\nM30\n").dialect, Dialect::fanuc);
  EXPECT_EQ(detect_dialect("O100 SUB\nG1 X1\nO100 ENDSUB\n").dialect, Dialect::linuxcnc);
  EXPECT_EQ(detect_dialect("o<x> call [1]\n").dialect, Dialect::linuxcnc);
  EXPECT_EQ(detect_dialect("$X\nG21\n").dialect, Dialect::grbl);
  EXPECT_EQ(detect_dialect("M117 hi\nG1 X1 F5\n").dialect, Dialect::marlin);
  EXPECT_EQ(detect_dialect("(IF [GOTO] G65P)\nG1 X1\n").dialect, Dialect::linuxcnc) << "comments do not count";
}

TEST(Fanuc, LoopsJumpsAndBranchesRun) {
  const auto reading = read_as(Dialect::fanuc,
                               "%\nO0001 (LOOP)\nG21 G90 F100\n#1=0\nWHILE [#1 LT 3] DO1\n#1=#1+1\nG1 X#1\nEND1\n"
                               "IF [#1 EQ 3] GOTO 50\nG1 X99\nN50 IF [#1 EQ 3] THEN #2=7\nG1 X#2\nM30\n%\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading), (Values{1, 2, 3, 7}));
}

TEST(Fanuc, MacroCallsHaveTheirOwnLocals) {
  const auto reading = read_as(Dialect::fanuc,
                               "O1\nG21 G90 F100\n#1=5\nG65 P9010 A1. B2. I30 J40 I50 L2\nG1 X#1\nM30\n"
                               "O9010\nG1 X#1 Y#2\nG1 X#4 Y#5\nG1 X#7\n#1=77\nM99\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading), (Values{1, 30, 50, 1, 30, 50, 5}));
}

TEST(Fanuc, MacroArgumentsMayBeLettersThatMeanOtherThingsElsewhere) {
  const auto reading =
      read_as(Dialect::fanuc, "O1\nG21 F100\nG65 P9010 U1 V2 W3 M4 @5\nM30\nO9010\nG1 X#21 Y#22 Z#23\nX#13\nM99\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading), (Values{1, 4}));
}

TEST(Fanuc, VacantVariablesLeaveWordsOut) {
  const auto reading =
      read_as(Dialect::fanuc, "O1\nG21 G90 F100\nG1 X1 Y2\nG1 X3 Y#20\nIF [#20 EQ #0] GOTO 9\nG1 X99\nN9 G1 X4\nM30\n");
  EXPECT_EQ(ends(reading, 0), (Values{1, 3, 4}));
  EXPECT_EQ(ends(reading, 1), (Values{2, 2, 2}));
}

TEST(Fanuc, SubProgramsRepeatByEitherForm) {
  const std::string sub = "M30\nO1000\nG91 G1 X1\nG90\nM99\n";
  EXPECT_EQ(ends(read_as(Dialect::fanuc, "O1\nG21 F100\nM98 P1000 L2\n" + sub)), (Values{1, 2}));
  EXPECT_EQ(ends(read_as(Dialect::fanuc, "O1\nG21 F100\nM98 P00031000\n" + sub)), (Values{1, 2, 3}));
}

TEST(Fanuc, DwellsAreInMilliseconds) {
  const auto reading = read_as(Dialect::fanuc, "O1\nG4 P500\nG4 X2.5\nM30\n");
  EXPECT_EQ(reading.moves.dwells, (Values{0.5, 2.5}));
}

TEST(Fanuc, ADwellMovesNoAxis) {
  EXPECT_EQ(ends(read_as(Dialect::fanuc, "O1\nG21 G90 G0 X1\nG4 X2.5\nM30\n")), (Values{1}));
}

TEST(Fanuc, TheMotionCodeBeforeACycleGoesOnAfterIt) {
  const auto reading = read_as(Dialect::fanuc, "O1\nG21 G90 G1 X1 F100\nG81 X2 Z-1 R1\nG80\nX3\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(reading.moves.kind.at(reading.moves.size() - 2), MoveKind::feed);
  EXPECT_EQ(ends(reading).back(), 3.0);
}

TEST(Fanuc, WhatWouldChangeThePathUnseenIsRefused) {
  const std::pair<const char*, const char*> cases[] = {{"G12.1", "g-code-unfollowed"},
                                                       {"G7.1 C10", "g-code-unfollowed"}};
  for (const auto& [line, code] : cases) {
    const auto reading = read_as(Dialect::fanuc, fmt::format("O1\n{}\nM30\n", line));
    EXPECT_TRUE(reading.refused) << line;
    EXPECT_EQ(reading.diagnostics.at(0).code, code) << line;
  }
  const auto smoothing = read_as(Dialect::fanuc, "O1\nG05 P10000\nG05.1 Q1\nG21 G1 X1. F100\nG05 P0\nM30\n");
  EXPECT_EQ(codes(smoothing), (Codes{"g-code-ignored@2:1", "g-code-ignored@5:1"}));
}

TEST(Fanuc, TheTurnedPlaneTurnsAboutItsCentre) {
  // (20, 0) turned by 90° about (10, 0) is (10, 10).
  const auto reading = read_as(Dialect::fanuc, "O1\nG21 G90 F100\nG68 X10 Y0 R90\nG1 X20 Y0\nG69\nG1 X0 Y0\nM30\n");
  EXPECT_EQ(ends(reading, 0), (Values{10, 0}));
  EXPECT_EQ(ends(reading, 1), (Values{10, 0}));
}

TEST(Fanuc, AnAlarmStopsWithItsText) {
  const auto reading = read_as(Dialect::fanuc, "O1\n#3000=12 (TOOL MISSING)\nM30\n");
  ASSERT_EQ(reading.diagnostics.size(), 1u);
  EXPECT_EQ(reading.diagnostics[0].code, "program-alarm");
  EXPECT_NE(reading.diagnostics[0].message.find("TOOL MISSING"), std::string::npos);
}

TEST(Fanuc, AMainProgramThatRepeatsForEverIsReadOnce) {
  const auto reading = read_as(Dialect::fanuc, "O1\nG21 F100\nG1 X1.\nM99\n");
  EXPECT_FALSE(reading.refused);
  EXPECT_EQ(codes(reading), (Codes{"program-repeats@4:1"}));
}

TEST(Grbl, SettingsAndPrinterLinesMoveNothing) {
  const auto reading =
      read_as(Dialect::grbl, "$H\n$100=250\nM117 Hello (world\nG21 G90\nX5\nG1 X10 F600 *71\nM106 S255\nG0 Y2\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading), (Values{5, 10, 10}));
}

TEST(Grbl, RealtimeCharactersAreNoBlocksAndJogsAreTold) {
  const auto reading = read_as(Dialect::grbl, "?\n !\n~\n$J=G91 X10 F100\n$H\n$$\nG21 G1 X1 F100\n");
  EXPECT_EQ(codes(reading), (Codes{"sender-command@4:1", "sender-command@5:1"}));
  EXPECT_EQ(ends(reading), (Values{1}));
}

TEST(Printers, SettingsWithAxisLettersMoveNothing) {
  const auto reading = read_program(
      "M104 S200\nG28\nM92 X80 Y80 Z400 E93\nM201 X500 Y500\nM205 X8 Y8\nG92 E0\nG1 X5 E1 F600\n"
      "G1 X6 E2\nG92 X0 E0\n");
  EXPECT_EQ(reading.dialect, Dialect::marlin);
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading), (Values{0, 5, 6}));
  const Codes all = codes(reading);
  EXPECT_EQ(std::count(all.begin(), all.end(), "extruder-ignored@6:5"), 1);
  EXPECT_EQ(std::count_if(all.begin(), all.end(), [](const auto& c) { return c.rfind("extruder", 0) == 0; }), 1);
}

TEST(Printers, DwellInMillisecondsByPAndInSecondsByS) {
  const auto printer = read_program("M140 S60\nG4 P500\nG4 S2\nG4 X9\n");
  EXPECT_EQ(printer.moves.dwells, (Values{0.5, 2, 9}));
  const auto router = read_program("$X\nG4 P0.5\n");
  EXPECT_EQ(router.moves.dwells, (Values{0.5}));
}

TEST(Printers, AreKnownByTheirChecksums) {
  EXPECT_EQ(detect_dialect("N1 G28*18\nN2 G1 X10 F600*82\n").dialect, Dialect::marlin);
  EXPECT_EQ(detect_dialect("G1 X[2*3]\nG1 Y#1\n").dialect, Dialect::linuxcnc);
}

TEST(Grbl, AWordThatTheDialectLacksIsNamed) {
  const auto reading = read_as(Dialect::grbl, "G21\nG83 X1 Z-1 R1 Q1 F100\n");
  ASSERT_FALSE(reading.diagnostics.empty());
  EXPECT_EQ(reading.diagnostics[0].code, "code-not-in-dialect");
  EXPECT_NE(reading.diagnostics[0].message.find("G83"), std::string::npos);
}

TEST(Encodings, CommentsOfAnyEncodingPass) {
  const std::string gbk = "(\xD6\xD0\xCE\xC4)",
                    latin =
                        "(M\xFC"
                        "ller)",
                    utf8 = "(Деталь 零件)";
  for (const auto& comment : {gbk, latin, utf8}) {
    const auto reading =
        read_program("\xEF\xBB\xBFG21 " + comment + "\nG1 X1 F100 " + comment + " ;" + comment + "\nM2\n");
    EXPECT_TRUE(reading.diagnostics.empty());
    EXPECT_EQ(ends(reading), (Values{1}));
  }
}

TEST(Encodings, Utf16IsNamed) {
  const auto little = read_text(std::string("\xFF\xFEG\0001\0", 6), "a.ngc");
  ASSERT_FALSE(little);
  EXPECT_EQ(little.error().code, "text-utf-16");
  EXPECT_EQ(read_text(std::string("\xFE\xFF\000G\0001", 6), "a.ngc").error().code, "text-utf-16");
}

TEST(Encodings, LettersThatOnlyLookLikeOursAreNamed) {
  const auto cyrillic = read_program("G21\nМ2\n");
  EXPECT_EQ(cyrillic.diagnostics.at(0).message, "'М' (U+041C) begins no word");
  EXPECT_EQ(read_program("\xCC\x41\nM2\n").diagnostics.at(0).message, "byte 0xCC begins no word");
}

TEST(Encodings, AllLineEndsCount) {
  for (const char* end : {"\n", "\r\n", "\r"}) {
    const std::string e = end;
    EXPECT_EQ(ends(read_program("G21 F100" + e + "G1 X1" + e + "X2" + e + "M2" + e)), (Values{1, 2}));
  }
}

}  // namespace
}  // namespace toolpace::nc
