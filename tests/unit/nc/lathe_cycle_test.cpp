/// G70, G71 and G72: what they refuse, and what passes by hand.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reading_test_support.h"

namespace toolpace::nc {
namespace {

std::string with_contour(const std::string& contour, const std::string& cycle) {
  return "G21 G18 F100\nO100 sub\n" + contour + "O100 endsub\nG0 X20 Z5\n" + cycle + "\nM2\n";
}

Codes refused(const std::string& contour, const std::string& cycle) {
  return codes(read_program(with_contour(contour, cycle)));
}

const char* const kStep = "G0 X6 Z0\nG1 Z-5\nX10 Z-7\n";

// By hand: levels X10 8 6.5 (the contour at 6, D 0.5) down to Z-5 and its slope, 0.5 off: z = -5 + 0.5(√2 − 1) + … at 45°.
TEST(LatheCycle, RoughsLevelByLevelDownToTheAllowance) {
  const auto reading = read_program(with_contour("G0 X6 Z0\nG1 Z-5\nX10\n", "G71 Q100 X10 Z1 D0.5 I2 R0.2"));
  EXPECT_EQ(codes(reading), Codes{});
  Values feeds_x, feeds_z;
  for (std::size_t i = 0; i < reading.moves.size(); ++i) {
    if (reading.moves.kind[i] != MoveKind::feed) continue;
    feeds_x.push_back(std::round(reading.moves.end[i][0] * 1e9) / 1e9);
    feeds_z.push_back(std::round(reading.moves.end[i][2] * 1e9) / 1e9);
  }
  // Passes at 10 and 8 end half a millimetre before the shoulder at Z-5; the last follows the widened contour out.
  EXPECT_EQ(feeds_x, (Values{10.0, 8.0, 6.5, 10.0}));
  EXPECT_EQ(feeds_z, (Values{-4.5, -4.5, -4.5, -4.5}));
}

TEST(LatheCycle, EveryRowStandsInTheLineOfTheCycle) {
  const auto reading = read_program(with_contour(kStep, "G71 Q100 X10 Z1"));
  ASSERT_GT(reading.moves.size(), 5u);
  for (std::size_t i = 1; i + 1 < reading.moves.size(); ++i) EXPECT_EQ(reading.moves.line[i], 8u);
}

TEST(LatheCycle, ContoursSeeTheirOwnPosition) {
  const auto one = read_program(with_contour(kStep, "G70 Q100 X10 Z1"));
  const auto other =
      read_program(with_contour("G0 X6 Z0\nG1 X#<_x> Z[#<_z> - 5]\nG1 X[#<_x> + 4] Z[#<_z> - 2]\n", "G70 Q100 X10 Z1"));
  EXPECT_EQ(ends(one, 0), ends(other, 0));
  EXPECT_EQ(ends(one, 2), ends(other, 2));
}

TEST(LatheCycle, RefusesWhatItCannotTurn) {
  EXPECT_EQ(refused(kStep, "G71 X10 Z1"), Codes{"lathe-words@8:1"});
  EXPECT_EQ(refused(kStep, "G71 Q7 X10 Z1"), Codes{"sub-program-unknown@8:5"});
  EXPECT_EQ(refused(kStep, "G71 Q1.5 X10 Z1"), Codes{"lathe-words@8:5"});
  EXPECT_EQ(refused(kStep, "G71 Q100 X10 Z1 I0"), Codes{"lathe-words@8:17"});
  EXPECT_EQ(refused(kStep, "G72 Q100 X10 Z1 R-1"), Codes{"lathe-words@8:17"});
  EXPECT_EQ(refused(kStep, "G70 Q100 X10 Z1 P0"), Codes{"lathe-words@8:17"});
  EXPECT_EQ(refused(kStep, "G70 Q100 X10 Z1 I1"), Codes{"word-unused@8:17"});
  EXPECT_EQ(refused(kStep, "G17 G71 Q100 X10 Z1"), Codes{"lathe-plane@8:5"});
  EXPECT_EQ(refused(kStep, "G42.1 D0.5\nG71 Q100 X10 Z1"), Codes{"lathe-compensation@9:1"});
  EXPECT_EQ(refused("G0 X6 Z0\nG1 Z-5\nZ-3\nX10\n", "G71 Q100 X10 Z1"), Codes{"lathe-contour-turns-back@9:1"});
  EXPECT_EQ(refused("G0 X6 Z0\nG2 X6 Z-4 I-3 K-2\nG1 X10\n", "G71 Q100 X10 Z1"), Codes{"lathe-contour-turns-back@8:1"});
  EXPECT_EQ(refused("G0 X6 Z0\nG2 X8 Z-4\n", "G71 Q100 X10 Z1"), Codes{"arc-incomplete@4:1"});
  EXPECT_EQ(refused("G0 X6 Z0\nG2 X8 Z-4 R1\n", "G71 Q100 X10 Z1"), Codes{"arc-radius-too-small@4:11"});
  EXPECT_EQ(refused("G0 X6 Z0\nG5 X8 Z-4\n", "G71 Q100 X10 Z1"), Codes{"lathe-contour-motion@4:1"});
  EXPECT_EQ(refused("G0 X6 Z0\nG1 X8 U1\n", "G71 Q100 X10 Z1"), Codes{"lathe-contour-words@4:7"});
  EXPECT_EQ(refused("G0 X6 Z0\nG1 Z-1 A5\nX10\n", "G71 Q100 X10 Z1"), Codes{"lathe-corner-too-large@8:1"});
  EXPECT_EQ(refused("G0 X6 Z0\nG71 Q100 X10 Z1\n", "G71 Q100 X10 Z1"), Codes{"lathe-contour-motion@4:1"});
  EXPECT_EQ(refused("", "G71 Q100 X10 Z1"), Codes{"lathe-contour-empty@5:5"});
  EXPECT_EQ(refused("G0 X6 Z0\nG1 Z-1 F50 M8\nX10\n", "G71 Q100 X10 Z1"), Codes{"lathe-contour-unused@4:1"});
}

TEST(LatheCycle, IsNoCodeOfOtherDialects) {
  const auto reading = read_as(Dialect::fanuc, "G71 U2. R1.\nM30\n");
  EXPECT_EQ(codes(reading), Codes{"g-code-unfollowed@1:1"});
}

TEST(LatheCycle, NoFaultInAContourIsLost) {
  EXPECT_EQ(refused("G0 X6 Z0\nG1 Z-5 Q\nX10 J\n", "G71 Q100 X10 Z1"),
            (Codes{"number-expected@4:8", "number-expected@5:5"}));
}

TEST(LatheCycle, TinyStepsAndManyElementsMeetABound) {
  EXPECT_EQ(refused(kStep, "G71 Q100 X1000000 Z1 I0.000001"), Codes{"lathe-too-many-passes@8:1"});
  std::string zigzag = "#1=0\nG0 X1 Z0\nO101 repeat [20000]\nG1 W-0.001 X[2 - #1]\n#1=[1 - #1]\nO101 endrepeat\n";
  const auto reading = read_program(with_contour(zigzag, "G71 Q100 X10 Z1 I0.0001 D0.1"));
  EXPECT_TRUE(reading.refused);
}

// The lines of a loop around a cycle count towards the bound with the cycle's calculation.
TEST(LatheCycle, WorkOfCyclesInLoopsIsBounded) {
  const ReadLimits small{.loop_turns = 1'000'000, .blocks = 100'000'000, .lines = 100'000};
  const std::string text = "G21 G18 F100\nO100 sub\n" + std::string(kStep) +
                           "O100 endsub\nG0 X20 Z5\nG5 X\nO1 while [1]\nG71 Q100 X10 Z1 I0.001\nO1 endwhile\nM2\n";
  const auto found = codes(read_program(text, {.limits = small}));
  ASSERT_FALSE(found.empty());
  EXPECT_NE(
      std::find_if(found.begin(), found.end(), [](const std::string& c) { return c.rfind("too-many-lines", 0) == 0; }),
      found.end());
}

}  // namespace
}  // namespace toolpace::nc
