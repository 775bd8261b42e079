/// Programs of many origins, a small one for each kind of construct that was once refused or misread.

#include "reading_test_support.h"

namespace toolpace::nc {
namespace {

std::vector<MoveKind> kinds(const Reading& reading) {
  std::vector<MoveKind> list;
  for (const MoveKind kind : reading.moves.kind) {
    if (is_motion(kind)) list.push_back(kind);
  }
  return list;
}

Dialect dialect_of(const std::string& text, const std::string& name = "a.nc") {
  return read_program(text, {}, name).dialect;
}

// Marlin, RepRapFirmware and Klipper know one feedrate for G0 and G1.
TEST(Printers, MoveByTheFeedInG0Too) {
  const auto reading = read_as(Dialect::marlin, "G0 X100 F600\nG1 X0 F1200\nG0 X50\n");
  EXPECT_EQ(kinds(reading), std::vector<MoveKind>(3, MoveKind::feed));
  EXPECT_EQ(reading.moves.feed.at(0), 10.0);
  EXPECT_EQ(reading.moves.feed.at(2), 20.0);
}

TEST(Printers, AreKnownByTheirExtruderTheirMotorsAndLettersAlone) {
  EXPECT_EQ(dialect_of("G90\nG1 X10 Y20 F3000 E0.5\n"), Dialect::marlin);
  EXPECT_EQ(dialect_of("G0 X1 F600\nM84\n"), Dialect::marlin);
  EXPECT_EQ(dialect_of("G28 X Y\nG0 X1 F600\n"), Dialect::marlin);
  EXPECT_EQ(dialect_of("G21 G90\nG1 X1e5 F600\nM30\n"), Dialect::linuxcnc) << "an exponent is no extruder";
}

TEST(MachineMoves, AreRapidOnFanucsControllersUnlessG1StandsBeside) {
  const auto reading = read_as(Dialect::fanuc, "G21 G90\nG1 X10. F100.\nG53 Z5.\nX20.\nG53 G1 Z6.\nM30\n");
  EXPECT_EQ(kinds(reading), (std::vector<MoveKind>{MoveKind::feed, MoveKind::rapid, MoveKind::feed, MoveKind::feed}));
  EXPECT_EQ(kinds(read_as(Dialect::linuxcnc, "G21 G90 G1 X10 F100\nG53 Z5\nM2\n")).back(), MoveKind::feed);
}

TEST(Lathes, GoOnAsBeforeBehindThreadsAndGrooves) {
  const auto reading = read_as(Dialect::fanuc_lathe,
                               "G21 G97 S500 M3\nG0 X22. Z2.\nG76 P010060 Q100 R0.05\nG76 X18.16 Z-18. P920 Q300 F1.5\n"
                               "X50. Z50.\nG75 R.5\nG75 X30. P5000 F.05\nX60.\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  const std::size_t last = reading.moves.size() - 2;
  EXPECT_EQ(xyz(reading.moves, last), (Values{30, 0, 50}));
  EXPECT_EQ(reading.moves.kind[last], MoveKind::rapid);
}

// R10 is 0.001 in, as 0.01 in of the first cut are Q100: 0.4995 in - 0.01 in is the first diameter's half.
TEST(Lathes, TakeTheLastCutOfAThreadInIncrements) {
  const auto reading =
      read_as(Dialect::fanuc_lathe,
              "G20 G97 S500 M3\nG0 X1.1 Z.2\nG76 P010060 Q20 R10\nG76 X.923 Z-1. P380 Q100 F.0625\nM30\n");
  std::vector<double> depths;
  for (std::size_t i = 0; i < reading.moves.size(); ++i) {
    if (reading.moves.kind[i] == MoveKind::feed) depths.push_back(reading.moves.end[i][0] / 25.4);
  }
  ASSERT_EQ(depths.size(), 14u);  // n cuts are √n·0.01 in deep, each 0.002 in at least: 13 to 0.037, and the last one
  EXPECT_NEAR(depths.front(), 0.4995 - 0.01, 1e-9);
  EXPECT_NEAR(depths[12], 0.4995 - 0.037, 1e-9);
  EXPECT_NEAR(depths.back(), 0.4615, 1e-9);
}

TEST(Lathes, TurnArcsByRadiusToIncrements) {
  const auto reading = read_as(Dialect::fanuc_lathe, "G21 G98\nG0 X20. Z0.\nG3 U10. W-5. R5. F100\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(xyz(reading.moves, 1), (Values{15, 0, -5}));
}

// In system A they are cycles; no program gives a cycle beside G0 or G1.
TEST(Lathes, ReadG90AndG94BesideMotionAsInSystemB) {
  const auto reading =
      read_as(Dialect::fanuc_lathe, "G21 S1000 M3\nG0 G90 X50. Z2.\nG94 G1 Z-20. F200\nG90 G94\nX60. F100\nM30\n");
  EXPECT_EQ(codes(reading), (Codes{"lathe-system-b@2:4", "lathe-system-b@3:5", "lathe-system-b@4:1"}));
  EXPECT_EQ(xyz(reading.moves, 0), (Values{25, 0, 2}));
  EXPECT_NEAR(reading.moves.feed.at(1), 200.0 / 60, 1e-12);
  EXPECT_NEAR(reading.moves.feed.at(2), 100.0 / 60, 1e-12);
}

// 0.2 mm a minute would turn 300 mm within a day; 0.2 mm a turn at 600 turns a minute is 2 mm/s.
TEST(Lathes, TakeNoFeedForOneAMinuteThatIsATurns) {
  const auto reading = read_as(Dialect::fanuc_lathe, "G21 G90 G94\nG97 S600 M3\nG0 X50. Z2.\nG1 Z-20. F0.2\nM30\n");
  EXPECT_TRUE(has_code(reading, "feed-a-turn"));
  EXPECT_NEAR(reading.moves.feed.at(1), 2.0, 1e-12);
}

TEST(Lathes, AreKnownThoughM6OrYStandsInThem) {
  const std::string roughing = "G0 X52. Z2.\nG71 U2. R.5\nG71 P10 Q20 U.4 W.1 F.2\nN10 G0 X40.\nN20 G1 Z-9.\nM30\n";
  EXPECT_EQ(dialect_of("G21 S900 M3\nT1 M6\n" + roughing), Dialect::fanuc_lathe);
  EXPECT_EQ(dialect_of("G21\nT0101 M06\nG0 X50. Z2.\nG28 U0 W0\nM30\n"), Dialect::fanuc_lathe);
  EXPECT_EQ(dialect_of("O1\nG21 G98 T0707\nG0 X60. Z5. Y0\nG1 X30. Y10. F100\nG28 U0 V0\nM30\n"), Dialect::fanuc_lathe);
  EXPECT_EQ(dialect_of("G21\nG0 X50. Z2.\nG1 Z-20. F0.2 S1000 M3\nM30\n"), Dialect::fanuc_lathe);
  EXPECT_EQ(dialect_of("G21\nG0 X50 Z2\nG1 Z-20 F200\nM30\n"), Dialect::linuxcnc) << "a feed a minute";
  EXPECT_EQ(dialect_of("(Mach3Turn)\nG21 G18\nM6 T0101\nG1 Z-10. F.1\nX2.\nM30\n"), Dialect::mach3);
}

TEST(Units, ThatAreNeverGivenAreToldWhereTheyAreASetting) {
  EXPECT_EQ(codes(read_as(Dialect::fanuc, "G90\nG0 X1.\nM30\n")), (Codes{"units-missing@2:0"}));
  EXPECT_EQ(codes(read_as(Dialect::fanuc, "G20\nG0 X1.\nM30\n")), Codes{});
  EXPECT_EQ(codes(read_as(Dialect::grbl, "G0 X1\n")), Codes{});
}

TEST(Ends, MotionBehindThemIsTold) {
  EXPECT_EQ(codes(read_program("G21\nG0 X1\nM30\n\nG0 X5\n", {}, "a.nc")), (Codes{"text-behind-end@5:0"}));
  EXPECT_EQ(codes(read_program("G21\nG0 X1\nM30\n(END)\n%\n", {}, "a.nc")), Codes{});
  EXPECT_EQ(codes(read_program("O1\nG21\nM98 P2\nM30\nO2\nG0 X5.\nM99\n", {}, "a.nc")), Codes{});
}

TEST(Tips, M128IsDoubtfulWhereRotaryAxesMoveBehindIt) {
  const std::string head = "O1\nG21 G90\nM128\n";
  EXPECT_TRUE(has_code(read_program(head + "G1 X1. A10. F100\nM30\n", {}, "a.nc"), "tip-doubtful"));
  EXPECT_FALSE(has_code(read_program(head + "G1 X1. F100\nM30\n", {}, "a.nc"), "tip-doubtful"));
}

TEST(Blocks, MayBeDeletedByNumberInAnyDialectButLinuxcncs) {
  const std::string text = "G21\n/2 G0 X1\nG0 X2 /3 Y5\nM30\n";
  EXPECT_EQ(ends(read_program(text, {}, "a.nc")), (Values{1, 2}));
  EXPECT_EQ(ends(read_program(text, {.block_delete = true}, "a.nc"), 1), (Values{0}));
  EXPECT_TRUE(read_program(text).refused);
}

TEST(Messages, ForTheOperatorMoveNothing) {
  const auto reading = read_program("G21 G90\nMSG \"Load T11\"\nG0 X1\nDlgMsg \"Go on?\"\nM30\n", {}, "a.tap");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading), (Values{1}));
}

TEST(TinyG, TellsWhereItStands) {
  const auto reading = read_program("G21 G90\nG0 X10\nG28.3 X0\nG28.2 X0\nG0 X5\nM30\n", {}, "a.nc");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading), (Values{10, 15}));
}

// The spindle turns no faster than 1000: at X20 100 m/min are 1592 turns a minute.
TEST(Systems, WithoutAxesDoNothingOutsideOfLinuxcnc) {
  const auto reading = read_program("G21 G90\nG52\nG92\nG0 X1\nM30\n", {}, "a.nc");
  EXPECT_EQ(codes(reading), (Codes{"axes-missing@2:1", "axes-missing@3:1"}));
  EXPECT_EQ(ends(reading), (Values{1}));
  EXPECT_TRUE(read_as(Dialect::linuxcnc, "G52\nM2\n").refused);
}

TEST(Spindles, AreLimitedByG92Too) {
  const auto reading = read_as(Dialect::fanuc_lathe_b, "G21 G92 S1000\nG96 S100 M3\nG0 X20. Z2.\nG1 Z0 F.6\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_NEAR(reading.moves.feed.at(1), 10.0, 1e-12);
  EXPECT_FALSE(read_program("G21 G92 S1000\nG0 X1\nM30\n", {}, "a.nc").refused);
  EXPECT_TRUE(read_as(Dialect::linuxcnc, "G92 S1000\nM2\n").refused);
}

TEST(Macros, OfBuildersHaveNumbersFromNineHundredThousand) {
  const auto reading = read_as(Dialect::fanuc, "G21\n#900001=5.\n#901248=#900001+1.\nG0 X#901248\nY#999999\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading), (Values{6}));
  EXPECT_TRUE(read_as(Dialect::fanuc, "#200000=1\nM30\n").refused);
}

TEST(Calls, BeginAtALineOfTheirOwn) {
  EXPECT_EQ(ends(read_as(Dialect::fanuc, "G21\nM98 P2 Q10\nM30\nO2\nG0 X1.\nN10 X2.\nM99\n")), (Values{2}));
  EXPECT_TRUE(read_as(Dialect::fanuc, "G21\nM98 P2 Q10 L2\nM30\nO2\nN10 G0 X2.\nM99\n").refused);
  EXPECT_EQ(ends(read_as(Dialect::fanuc, "G21\nM98 H10 L2\nM30\nN10 G91 G0 X5.\nM99\n")), (Values{5, 10}));
}

TEST(Brother, ChangesToolsOnTheWay) {
  const auto reading = read_as(Dialect::fanuc, "G21 G90\nG0 Z9.\nG100 T2 X1. Y2. Z50. G43 H2 S8000 M3\nG100\nM30\n");
  EXPECT_EQ(std::count(reading.moves.kind.begin(), reading.moves.kind.end(), MoveKind::tool), 1);
  EXPECT_EQ(ends(reading, 0), (Values{0, 1, 1}));
  EXPECT_EQ(ends(reading, 2), (Values{9, 9, 50}));
  EXPECT_TRUE(has_code(reading, "g-code-machine"));
}

TEST(Arcs, MayBeSmallerThanLinuxcncsLeast) {
  const std::string text = "G21 G90\nG2 X0.001 Y0.001 I0.001 J0 F100\nM30\n";
  EXPECT_FALSE(read_program(text, {}, "a.nc").refused);
  EXPECT_TRUE(read_program(text).refused);
}

TEST(Heads, MayHaveZerosForTheLetterO) {
  const auto reading = read_program("%\n00024 (SIGN)\nG21 G0 X1\nM30\n%\n", {}, "a.nc");
  EXPECT_EQ(codes(reading), (Codes{"program-number@2:1"}));
  EXPECT_EQ(ends(reading), (Values{1}));
  EXPECT_TRUE(read_program("G21 G0 X1\n00024\nM30\n", {}, "a.nc").refused);
}

TEST(Text, TapesBeginAndEndWithoutHoles) {
  using namespace std::string_literals;
  const auto reading = read_program("\0\0%\n\x7F\x7FO1\nG21 G0 X1.\nM30\n%\0\0"s, {}, "a.nc");
  EXPECT_EQ(codes(reading), Codes{});
  EXPECT_EQ(ends(reading), (Values{1}));
}

TEST(Channels, AreRefusedWithAWord) {
  for (const char* text : {"O1\n$1\nG0 X1.\nM30\n", "O1\n!L1\nG0 X1.\nM30\n", "O1\n!2 L100\nG0 X1.\nM30\n"})
    EXPECT_EQ(codes(read_program(text, {}, "a.nc")).front(), "several-channels@2:1") << text;
}

TEST(Foreign, LanguagesThatLookLikeGCodeAreNamed) {
  struct Case {
    const char* text;
    const char* name;
  };
  const Case cases[] = {{"N1 O2\nL100\nX1.\nM17\nM30\nG0 X2.\nL101\nM2\n", "Fadal"},
                        {"N10 T4.4\nN20 G0 X1\n", "Fagor"},
                        {"N10 G0 X1\nN20 G81 G99 X25 Y0 Z0 I-28 F100\n", "Fagor"},
                        {"N40 (IF P0 GT 5 GOTO N20)\n", "Fagor"},
                        {"N40 (P1=P1+2.5)\n", "Fagor"},
                        {"G50 S2500\nNAT01\nG0 X1\n", "Okuma"},
                        {"'SHOPBOT FILE\nSA\n", "ShopBot"},
                        {"M3,1,1,-0.1\n", "ShopBot"},
                        {"%@MACRO\n#1 := 5;\n", "Syntec"},
                        {"G0 X1\nG41 X25 Y=12+10\n", "Siemens"},
                        {"N5 G18 G54 DIAMON\n", "Siemens"}};
  for (const Case& c : cases) {
    const auto reading = read_text(c.text, "a.nc", {});
    ASSERT_FALSE(reading.has_value()) << c.text;
    EXPECT_EQ(reading.error().code, "language-unsupported");
    EXPECT_NE(reading.error().message.find(c.name), std::string::npos) << reading.error().message;
  }
  EXPECT_FALSE(read_program("#1=2\no1 if [#1 GT 1.5]\nG0 X1\no1 endif\nM2\n").refused);
  for (const char* text : {"M204 P500 T1500.5\n", "M117 Z=0.2\n", "M117 T1.5 DIAMOND\n", "SET_PIN P=1\n",
                           "(P1=START)\n", "(CALL 555-1234)\n", "(IF P1 IS LOOSE)\n"})
    EXPECT_FALSE(read_program(std::string(text) + "G28\nG1 X1 E1 F600\n", {}, "a.gcode").refused) << text;
  EXPECT_FALSE(read_program("(IF PART 5 IS LOOSE)\nG21 G83 Z-5 R1 Q1 I.5 F100 G98\nM30\n", {}, "a.nc").refused);
}

}  // namespace
}  // namespace toolpace::nc
