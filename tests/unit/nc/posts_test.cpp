/// What posts, older controllers and shops of all kinds write.

#include "reading_test_support.h"

namespace toolpace::nc {
namespace {

TEST(ToolTables, ThatAreMissingAreToldOnceWithARemedy) {
  const auto reading = read_as(Dialect::fanuc, "G21 G90\nT1 M6\nG43 H1 Z5.\nG43 H2 Z5.\nG1 X1. F100\nM30\n");
  ASSERT_EQ(codes(reading), (Codes{"tool-table-missing@3:1"}));
  EXPECT_EQ(reading.diagnostics[0].remedy, "give a tool table with --tools");
  EXPECT_TRUE(codes(read_as(Dialect::fanuc, "G21 G90\nG10 L10 P1 R20.\nT1 M6\nG43 H1 Z5.\nM30\n")).empty());
  EXPECT_TRUE(codes(read_as(Dialect::fanuc, "G21 G90\nT1 M6\nG0 Z5.\nM30\n")).empty());
  const auto radius = read_as(Dialect::fanuc, "G21 G90\nG41 D3 G1 X5. F100\nG40 X9.\nM30\n");
  EXPECT_EQ(codes(radius), (Codes{"tool-table-missing@2:1"}));
}

TEST(MainProgram, IsTheOneThatEndsWithM30) {
  const auto reading = read_as(Dialect::fanuc,
                               "%\nO0001 (SUB)\nG91 G1 X1. F100\nG90\nM99\nO0002\nM98 P3\nM99\n:3\nG1 Y2.\nM99\n"
                               "O1000 (MAIN)\nG21 G90 G94\nG0 X10.\nM98 P1 L2\nM98 P2\nM30\n%\n");
  EXPECT_EQ(ends(reading), (Values{10, 11, 12, 12}));
  EXPECT_EQ(codes(reading), (Codes{"main-program-behind@12:0"}));
}

TEST(MainProgram, IsTheFirstOneWhereItEndsItself) {
  const auto first = read_as(Dialect::fanuc, "O1\nG21 G90 G94\nM98 P2\nM30\nO2\nG1 X1. F100\nM99\nO3\nG1 X7.\nM30\n");
  EXPECT_EQ(ends(first), (Values{1}));
  EXPECT_TRUE(codes(first).empty());
  // A bar feeder's program repeats by M99, and nothing behind it ends.
  const auto repeats = read_as(Dialect::fanuc, "O1\nG21 G90 G94\nG1 X1. F100\nM99\nO2\nM99\n");
  EXPECT_EQ(codes(repeats), (Codes{"program-repeats@4:1"}));
  EXPECT_EQ(ends(repeats), (Values{1}));
}

TEST(MacroArithmetic, OfTypeAIsDone) {
  const auto value = [](const std::string& lines) {
    const auto reading = read_as(Dialect::fanuc, "G21 G90 G94\n" + lines + "G1 X#100 F100\nM30\n");
    EXPECT_FALSE(reading.refused) << lines << reading.diagnostics[0].message;
    const auto x = ends(reading);
    return x.empty() ? NAN : x.back();
  };
  EXPECT_EQ(value("G65 H01 P#100 Q5\n"), 5);
  EXPECT_EQ(value("G65 H1 P#101 Q4\nG65 H02 P#100 Q#101 R3\n"), 7);
  EXPECT_EQ(value("G65 H03 P#100 Q4 R3\n"), 1);
  EXPECT_EQ(value("G65 H04 P#100 Q4 R3\n"), 12);
  EXPECT_EQ(value("G65 H05 P#100 Q12 R3\n"), 4);
  EXPECT_EQ(value("G65 H11 P#100 Q5 R3\n"), 7);
  EXPECT_EQ(value("G65 H12 P#100 Q5 R3\n"), 1);
  EXPECT_EQ(value("G65 H13 P#100 Q5 R3\n"), 6);
  EXPECT_EQ(value("G65 H21 P#100 Q49\n"), 7);
  EXPECT_EQ(value("G65 H22 P#100 Q-3\n"), 3);
  EXPECT_EQ(value("G65 H23 P#100 Q17 R5\n"), 2);
  EXPECT_EQ(value("G65 H24 P#100 Q18\n"), 12);  // 0x12
  EXPECT_EQ(value("G65 H25 P#100 Q12\n"), 18);
  EXPECT_EQ(value("G65 H01 P#100 Q6\nG65 H26 P#100 Q4 R3\n"), 8);
  EXPECT_EQ(value("G65 H27 P#100 Q3 R4\n"), 5);
  EXPECT_EQ(value("G65 H28 P#100 Q5 R4\n"), 3);
  EXPECT_NEAR(value("G65 H31 P#100 Q10 R30\n"), 5, 1e-9);
  EXPECT_NEAR(value("G65 H34 P#100 Q-1 R-1\n"), 225, 1e-9);
}

TEST(MacroArithmetic, OfTypeAJumps) {
  const auto reading = read_as(Dialect::fanuc,
                               "G21 G90 G94 F100\nG65 H01 P#100 Q1\nN10 G1 X#100\nG65 H02 P#100 Q#100 R1\n"
                               "G65 H86 P10 Q#100 R3\nG65 H80 P99\nG1 X50.\nN99 M30\n");
  EXPECT_EQ(ends(reading), (Values{1, 2, 3}));
  const auto alarm = read_as(Dialect::fanuc, "G21\nG65 H99 P500\nM30\n");
  EXPECT_EQ(codes(alarm), (Codes{"program-alarm@2:1"}));
  EXPECT_EQ(codes(read_as(Dialect::fanuc, "G65 H05 P#100 Q1 R0\nM30\n")), (Codes{"macro-undefined@1:5"}));
  EXPECT_EQ(codes(read_as(Dialect::fanuc, "G65 H77 P#100 Q1\nM30\n")), (Codes{"macro-operation@1:5"}));
}

// K0 beside I and J in G17 is read. The end of the shared case lies 13 mm off its radius: grbl itself refuses that (error 33),
// and so does its dialect here.
TEST(Grbl, KInG17IsReadAndAnEndOffTheRadiusIsRefused) {
  const std::string head = "G17 G90 G21\nG0 X10 Y0 Z2\n";
  const auto fine = read_as(Dialect::grbl, head + "G2 X-10 Y0 Z2.000 I-10 J0 K0.000 F1000.000\nM2\n");
  EXPECT_FALSE(fine.refused);
  EXPECT_EQ(ends(fine), (Values{10, -10}));
  const auto off = read_as(Dialect::grbl, head + "G2 X-10 Y7 Z2.000 I-10 J0 K0.000 F1000.000\nM2\n");
  EXPECT_TRUE(has_code(off, "arc-radius-differs"));
}

// I first, then J less from peck to peck, down to K: 5, 8, 10 and 12 of 13 mm.
TEST(Haas, PecksShrink) {
  const auto reading =
      read_as(Dialect::haas, "G21 G90 G94 G99\nG0 X0. Y0. Z0.\nG83 Z-13. R0. I5. J2. K2. F100.\nG80\nM30\n");
  Values depths;
  for (std::size_t i = 0; i < reading.moves.size(); ++i) {
    if (reading.moves.kind[i] == MoveKind::feed) depths.push_back(reading.moves.end[i][2]);
  }
  EXPECT_EQ(depths, (Values{-5, -8, -10, -12, -13}));
}

TEST(Posts, NumberLinesOfToolChangesByAColon) {
  const std::string body = "N0020 G91 G28 Z0.0\n:0030 T01 M06\nN0040 G0 G90 X1. S100 M03\n:0050 X2.\nN60 M02\n";
  for (const std::string head : {"%\nN0010 G40 G17 G90 G21\n", "O1\nN0010 G40 G17 G90 G21\n"}) {
    const auto reading = read_program(head + body, {}, "a.ptp");
    EXPECT_FALSE(reading.refused);
    EXPECT_EQ(ends(reading), (Values{0, 0, 1, 2}));
    EXPECT_EQ(std::count(reading.moves.kind.begin(), reading.moves.kind.end(), MoveKind::tool), 1);
  }
}

TEST(Lathes, AreKnownByArcsWithoutAPlane) {
  const std::string text = "T01M06\nG97 S220 M03\nG00 X40. Z1.\nG01 Z0. F0.1\nG03 X42. Z-1. I0. K-1.\nM30\n";
  const auto reading = read_program(text, {}, "a.nc");
  EXPECT_EQ(reading.dialect, Dialect::fanuc_lathe);
  EXPECT_FALSE(reading.refused);
  EXPECT_EQ(ends(reading).back(), 21);
  EXPECT_EQ(read_program("G18\n" + text, {}, "a.nc").dialect, Dialect::linuxcnc);
  EXPECT_EQ(read_program(text, {}, "a.ngc").dialect, Dialect::linuxcnc);
}

TEST(Macros, HaveFunctionsOfTwoArguments) {
  const auto reading = read_as(Dialect::fanuc,
                               "G21 G90 G94\n#1=POW[2,3]\n#2=ATAN[1,[2-1]]\n#3=ATAN[1]/[-1]\n"
                               "G0 X#1 Y#2\nG4 U1.\nZ#3\nM30\n");
  EXPECT_FALSE(reading.refused);
  EXPECT_EQ(ends(reading, 0).back(), 8);
  EXPECT_NEAR(ends(reading, 1).back(), 45, 1e-9);
  EXPECT_NEAR(ends(reading, 2).back(), 135, 1e-9);
  EXPECT_TRUE(read_as(Dialect::fanuc, "#1=POW[2]\nM30\n").refused);
  EXPECT_TRUE(read_as(Dialect::fanuc, "#1=POW[2,]\nM30\n").refused);
}

TEST(Machines, DefineLongCodesAndNumberTheirSpindles) {
  const auto reading = read_as(Dialect::fanuc, "G1901 D120 E80\nG21 G90\nM3 S1=2000\nG0 X1.\nM30\n");
  EXPECT_EQ(codes(reading), (Codes{"g-code-machine@1:1"}));
  EXPECT_EQ(reading.modal.at(4)->spindle_speed, 2000);
}

TEST(Printers, CallMacrosByNameAndStopWithAText) {
  const auto reading = read_as(Dialect::marlin, "M98 P\"/macros/prime.g\"\nG1 X1 F600\nM0 Click to continue\nG1 X2\n");
  EXPECT_FALSE(reading.refused);
  EXPECT_EQ(ends(reading), (Values{1, 2}));
  EXPECT_FALSE(read_as(Dialect::marlin, "G1 X1 E1.5e-05 F600\n").refused);
}

TEST(Lathes, ChangeToolsOnceWhereM6StandsBesideT) {
  const auto reading = read_as(Dialect::fanuc_lathe, "G21\nT0101 M6\nT0202\nM6\nG0 X10.\nM30\n");
  EXPECT_EQ(std::count(reading.moves.kind.begin(), reading.moves.kind.end(), MoveKind::tool), 2);
}

TEST(Texts, InVariablesAndBehindMCodesMoveNothing) {
  const auto reading = read_as(Dialect::fanuc, "O1\nN10 #301 = \"Plate v13\" ; name\nM200 \"Load X9\"\nG0 X1.\nM30\n");
  EXPECT_FALSE(reading.refused);
  EXPECT_EQ(ends(reading), (Values{1}));
}

TEST(Dwells, WithoutATimeArePassedOverOutsideOfLinuxcnc) {
  EXPECT_EQ(codes(read_program("G21 G90\nG4\nG0 X1\nM30\n", {}, "a.nc")), (Codes{"dwell-without-time@2:1"}));
  EXPECT_TRUE(read_as(Dialect::linuxcnc, "G4\nM2\n").refused);
}

TEST(Siemens, IsKnownByItsVariables) {
  const auto reading = read_text("N10 G17 G90\nN20 R1=10 R2=R1*2\nN80 M30\n", "a.mpf");
  ASSERT_FALSE(reading);
  EXPECT_EQ(reading.error().code, "language-unsupported");
}

}  // namespace
}  // namespace toolpace::nc
