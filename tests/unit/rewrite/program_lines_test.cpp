#include "toolpace/rewrite/program_lines.h"

#include <gtest/gtest.h>

namespace toolpace::detail::rewrite {
namespace {

TEST(ProgramLinesOfAText, KeepTheirEnds) {
  const ProgramLines lines("G1 X1\r\n\nX2");
  ASSERT_EQ(lines.count(), 3u);
  EXPECT_EQ(lines.whole(1), "G1 X1\r\n");
  EXPECT_EQ(lines.content(1), "G1 X1");
  EXPECT_EQ(lines.ending(1), "\r\n");
  EXPECT_EQ(lines.content(2), "");
  EXPECT_EQ(lines.whole(3), "X2");
  EXPECT_EQ(lines.ending(3), "");
  EXPECT_EQ(ProgramLines("").count(), 0u);
}

TEST(APlainLine, IsAFeedMoveAndNothingElse) {
  const auto line = plain_line("N10 G01 X+1.50 z-2 F300");
  ASSERT_TRUE(line);
  EXPECT_EQ(line->label, "N10");
  EXPECT_EQ(line->motion, 1);
  EXPECT_EQ(line->axis[0], "+1.50");
  EXPECT_EQ(line->axis[1], "");
  EXPECT_EQ(line->axis[2], "-2");
  EXPECT_EQ(line->feed, "300");
  EXPECT_FALSE(line->has_centre);
  EXPECT_FALSE(line->has_points);
  EXPECT_TRUE(line->is_spaced);
  EXPECT_TRUE(plain_line("g3x1.y2.i.5")->is_lower);
  EXPECT_FALSE(plain_line("G3X1.Y2.I.5")->is_spaced);
  EXPECT_TRUE(plain_line("G3X1.Y2.I.5")->has_centre);
}

TEST(APlainLine, SaysNothingThatCouldBeLost) {
  for (const char* text : {"G0 X1",    "G1 X1 (here)", "G1 X1 ; here",
                           "G1 X1 M3", "G1 X1 S100",   "G1 X[1+1]",
                           "G1 X#1",   "G1",           "F100",
                           "",         "/ G1 X1",      "G1 G17 X1",
                           "X1 X2",    "G1 A1",        "X",
                           "X1.2.3",   "O100 call",    "G1 X1 E2",
                           "G1 X1 P2", "X1 *40",       "M2",
                           "%",        "G1.1 X1",      "G1 X1 N5"}) {
    EXPECT_FALSE(plain_line(text)) << text;
  }
}

TEST(TheMotionBehindARun, IsNamedByTheNextLineThatCouldNeedIt) {
  const auto is_named = [](std::string_view text) { return is_motion_named_from(ProgramLines(text), 1); };
  EXPECT_TRUE(is_named("G0 Z5\n"));
  EXPECT_TRUE(is_named("\n(rest)\nM5\nN7 G1 X1\n"));
  EXPECT_TRUE(is_named("M2\n"));
  EXPECT_TRUE(is_named(""));
  EXPECT_FALSE(is_named("X1 (here)\nG0 Z5\n"));
  EXPECT_FALSE(is_named("G4 P1\nG1 X1\n"));
  EXPECT_FALSE(is_named("O100 call\nG1 X1\n"));
  EXPECT_FALSE(is_named("(open\nG1 X1\n"));
}

}  // namespace
}  // namespace toolpace::detail::rewrite
