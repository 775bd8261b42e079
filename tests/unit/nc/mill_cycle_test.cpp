/// Cycles and patterns of mills of Fanuc's kind: what they do at each hole.

#include <numbers>

#include "reading_test_support.h"

namespace toolpace::nc {
namespace {

constexpr double kHalf = std::numbers::pi;

// Off the wall by Q along +X at the bottom, up to the initial level, back over the hole.
TEST(MillCycles, FineBoringLeavesTheWallBeforeItComesOut) {
  const auto reading =
      read_program("O76\nG21 G90 G17\nG0 X0 Y0 Z50.\nG98 G76 X10. Y10. Z-20. R2. Q0.5 P500 F50\nX30.\nG80\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading, 0), (Values{0, 10, 10, 10, 10.5, 10.5, 10, 30, 30, 30, 30.5, 30.5, 30}));
  EXPECT_EQ(ends(reading, 2), (Values{50, 50, 2, -20, -20, 50, 50, 50, 2, -20, -20, 50, 50}));
  EXPECT_EQ(reading.moves.dwells, (Values{0.5, 0.5}));
  const auto aside = read_program("O76\nG21 G90\nG0 Z5.\nG76 X0 Y0 Z-2. R2. I-1. J2. F50\nM30\n");
  EXPECT_EQ(ends(aside, 0), (Values{0, 0, 0, 0, -1, -1, 0}));
  EXPECT_EQ(ends(aside, 1), (Values{0, 0, 0, 0, 2, 2, 0}));
}

// R lies below the work: down there beside the hole, into it, up to Z, and all of it back.
TEST(MillCycles, BackBoringCutsUpwards) {
  const auto reading =
      read_program("O87\nG21 G90 G17\nG0 X0 Y0 Z20.\nG98 G87 X50. Y10. Z-5. R-30. Q3. P200 F40.\nG80\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading, 0), (Values{0, 50, 53, 53, 50, 50, 53, 53, 50}));
  EXPECT_EQ(ends(reading, 2), (Values{20, 20, 20, -30, -30, -5, -5, 20, 20}));
  EXPECT_EQ(reading.moves.dwells, (Values{0.2}));
  EXPECT_EQ(ends(read_as(Dialect::haas, "G21\nG0 Z20.\nG77 X1. Y0 Z-5. R-30. I2. F40.\nM30\n"), 0),
            (Values{0, 1, 3, 3, 1, 1, 3, 3, 1}));
}

TEST(MillCycles, APeckDeeperThanTheHoleIsInLeastIncrements) {
  const auto reading = read_program("O1\nG21 G90\nG0 Z10.\nG99 G83 X1. Y0 Z-5. R1. Q2000 F100\nG80\nM30\n");
  EXPECT_FALSE(reading.refused);
  EXPECT_TRUE(has_code(reading, "peck-in-increments"));
  EXPECT_EQ(ends(reading, 2), (Values{10, 10, 1, -1, 1, -0.746, -3, 1, -2.746, -5, 1}));
  const auto length = read_program("O1\nG21 G90\nG0 Z10.\nG99 G83 X1. Y0 Z-50. R1. Q20 F100\nG80\nM30\n");
  EXPECT_FALSE(has_code(length, "peck-in-increments")) << "20 mm of a hole of 51 mm";
}

TEST(MillCycles, NoRepeatsKeepTheWordsForLaterBlocks) {
  for (const char* none : {"L0", "K0"}) {
    const auto reading = read_program(std::string("O1\nG21 G90\nG0 X0 Y0 Z10.\nG99 G81 Z-1. R1. F100 ") + none +
                                      "\nX5. Y5.\nG80\nM30\n");
    EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
    EXPECT_EQ(ends(reading, 2), (Values{10, 10, 1, -1, 1})) << none;
    EXPECT_EQ(ends(reading, 0), (Values{0, 5, 5, 5, 5})) << none;
  }
}

TEST(MillCycles, ARotaryAxisTurnsOnTheWayToTheHole) {
  const auto reading = read_program("O1\nG21 G90\nG0 X0 Y0 Z10.\nG81 X5. A90. Z-1. R1. F100\nG80\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_NEAR(reading.moves.end.at(1)[3], kHalf / 2, 1e-12);
  EXPECT_EQ(reading.moves.kind.at(1), MoveKind::rapid);
}

TEST(MillCycles, AxesBesideG80MoveByTheMotionBefore) {
  const auto reading = read_program("O1\nG21 G90\nG0 X0 Z10.\nG81 X5. Z-1. R1. F100\nG80 Z25.\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading, 2).back(), 25.0);
  EXPECT_EQ(reading.moves.kind.at(reading.moves.size() - 2), MoveKind::rapid);
  EXPECT_TRUE(has_code(reading, "axes-with-g80"));
  EXPECT_TRUE(read_as(Dialect::linuxcnc, "G81 X5 Z-1 R1 F100\nG80 Z25\nM2\n").refused);
}

TEST(HolePatterns, LieOnACircleAnArcAndALine) {
  const std::string begin = "O1 (HAAS)\nG21 G90 G17\nG0 X1. Y2. Z5.\nG99 G81 Z-1. R1. F100 L0\n";
  const auto holes = [](const Reading& reading) {
    std::vector<Values> places;
    for (std::size_t i = 0; i < reading.moves.size(); ++i) {
      const auto p = xyz(reading.moves, i);
      if (reading.moves.kind[i] == MoveKind::feed)
        places.push_back({std::round(p[0] * 1e6) / 1e6, std::round(p[1] * 1e6) / 1e6});
    }
    return places;
  };
  const auto circle = read_program(begin + "G70 I10. J90. L4\nG80\nM30\n");
  EXPECT_FALSE(circle.refused) << testing::PrintToString(codes(circle));
  EXPECT_EQ(holes(circle), (std::vector<Values>{{1, 12}, {-9, 2}, {1, -8}, {11, 2}}));
  const auto arc = read_program(begin + "G71 I10. J0. K90. L2\nG80\nM30\n");
  EXPECT_EQ(holes(arc), (std::vector<Values>{{11, 2}, {1, 12}}));
  const auto line = read_program(begin + "G72 I10. J0. L3\nG80\nM30\n");
  EXPECT_EQ(holes(line), (std::vector<Values>{{1, 2}, {11, 2}, {21, 2}}));
  EXPECT_TRUE(has_code(read_program("O1 (HAAS)\nG70 I10. J90. L4\nM30\n"), "pattern-without-cycle"));
  EXPECT_TRUE(has_code(read_program(begin + "G70 J90. L4\nM30\n"), "pattern-words"));
}

// In along half a circle, round, and out along half a circle.
TEST(CircularPockets, OneCircleBeginsAndEndsInTheMiddle) {
  const auto reading = read_program("O1 (HAAS)\nG21 G90 G17\nG0 X10. Y10. Z1.\nG13 I5. Z-2. F100 D0\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading, 0), (Values{10, 10, 15, 15, 10}));
  EXPECT_EQ(ends(reading, 2), (Values{1, -2, -2, -2, -2}));
  ASSERT_EQ(reading.moves.arcs.size(), 3u);
  const double sweeps[] = {kHalf, 2 * kHalf, kHalf}, centres[] = {12.5, 10, 12.5};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(reading.moves.arcs[i].sweep, sweeps[i], 1e-9);
    EXPECT_NEAR(reading.moves.arcs[i].centre.x(), centres[i], 1e-9);
    EXPECT_NEAR(reading.moves.arcs[i].centre.y(), 10.0, 1e-9);
  }
}

TEST(CircularPockets, GrowByStepsUpToTheLastCircle) {
  const auto reading = read_program("O1 (HAAS)\nG21 G90 G17\nG0 X0 Y0 Z0\nG12 I2. K5. Q2. Z-1. F100\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading, 0), (Values{0, 0, 2, 2, 4, 4, 5, 5, 0}));
  ASSERT_EQ(reading.moves.arcs.size(), 5u);
  for (const ArcDetail& arc : reading.moves.arcs) EXPECT_LT(arc.sweep, 0.0) << "G12 goes clockwise";
}

TEST(CircularPockets, GoDeeperByPassesUnderG91) {
  const auto reading = read_program("O1 (HAAS)\nG21 G17\nG0 X0 Y0 Z0\nG91 G13 I3. Z-1. L3 F100\nG90 M30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading, 2), (Values{0, -1, -1, -1, -1, -2, -2, -2, -2, -3, -3, -3, -3}));
}

TEST(CircularPockets, NeedACircleAndSayWhichToolIsUnknown) {
  EXPECT_TRUE(has_code(read_program("O1 (HAAS)\nG21\nG13 Z-1. F100\nM30\n"), "pocket-words"));
  EXPECT_TRUE(has_code(read_program("O1 (HAAS)\nG21\nG18\nG13 I1. F100\nM30\n"), "pocket-plane"));
  const auto reading = read_program("O1 (HAAS)\nG21\nG13 I1. D7 F100\nM30\n");
  EXPECT_FALSE(reading.refused);
  EXPECT_TRUE(has_code(reading, "pocket-tool-unknown"));
}

TEST(CircularPockets, OfMach3AreReachedStraight) {
  const auto reading = read_as(Dialect::mach3, "G21 G90 G17\nG0 X0 Y0\nF100\nG12 I4\nM30\n");
  EXPECT_FALSE(reading.refused) << testing::PrintToString(codes(reading));
  EXPECT_EQ(ends(reading, 0), (Values{0, 4, 4, 0}));
  EXPECT_EQ(reading.moves.arcs.size(), 1u);
}

}  // namespace
}  // namespace toolpace::nc
