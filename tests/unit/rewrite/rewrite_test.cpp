#include "toolpace/rewrite/rewrite.h"

#include "written_again.h"

namespace toolpace {
namespace {

using test::chords;
using test::written_again;

constexpr double kPi = 3.14159265358979323846;

TEST(ALineOfShortPieces, BecomesOneLine) {
  std::string text = "(head)\nG21 G90 G94\nG0 X0 Y0\nG1 F600 X0.0200\n";
  for (int k = 2; k <= 500; ++k) text += fmt::format("X{:.4f}\n", 0.02 * k);
  const auto rewritten = written_again(text + "G0 Z5\nM2 (end)\n");
  EXPECT_EQ(rewritten.text, "(head)\nG21 G90 G94\nG0 X0 Y0\nG1 X10 F600\nG0 Z5\nM2 (end)\n");
  EXPECT_EQ(rewritten.replaced, 1u);
  EXPECT_LE(rewritten.max_deviation, 1e-6);
}

TEST(ACircleOfChords, BecomesOneArc) {
  const std::string text = "G21 G90 G94\nG0 X20 Y0\nG1 F600\n" + chords(20, 0, 2 * kPi, 1000) + "G0 Z5\nM2\n";
  const auto rewritten = written_again(text);
  EXPECT_EQ(rewritten.text, "G21 G90 G94\nG0 X20 Y0\nG1 F600\nG3 X20 Y0 I-20\nG0 Z5\nM2\n");
  // 0.1257 mm long, chords lie inside of the circle by 0.1257²/(8·20) = 1e-4 mm; their ends are rounded to 5e-5.
  EXPECT_LE(rewritten.max_deviation, 0.0003);
}

TEST(AHelixOfChords, BecomesOneHelix) {
  std::string text = "G21 G90 G94\nG0 X10 Y0 Z0\nG1 F600\n";
  for (int k = 1; k <= 1000; ++k) {
    const double angle = -10 * kPi * k / 1000;  // five turns clockwise, 1 mm down each
    text += fmt::format("X{:.4f} Y{:.4f} Z{:.4f}\n", 10 * std::cos(angle), 10 * std::sin(angle), -0.005 * k);
  }
  const auto rewritten = written_again(text + "M2\n");
  EXPECT_EQ(rewritten.text, "G21 G90 G94\nG0 X10 Y0 Z0\nG1 F600\nG2 X10 Y0 Z-5 I-10 P5\nM2\n");
  // Of grbl's, each turn is a block of its own.
  const auto for_grbl = written_again(text + "M2\n", {}, Dialect::grbl);
  EXPECT_EQ(for_grbl.replaced, 5u);
  EXPECT_EQ(for_grbl.text.find('P'), std::string::npos);
}

TEST(ArcsInOtherPlanes, LeaveThePlaneAsItWas) {
  std::string text = "G21 G90 G94 G17\nG0 X0 Y0 Z10\nG1 F600\n";
  for (int k = 1; k <= 100; ++k) {
    const double angle = 2.0 * k / 100;
    text += fmt::format("X{:.4f} Z{:.4f}\n", 10 * std::sin(angle), 10 * std::cos(angle));
  }
  // From Z towards X is counter-clockwise in G18.
  const auto rewritten = written_again(text + "G2 X0 Y5 R20\nM2\n");
  EXPECT_NE(rewritten.text.find("\nG18 G3 X9.093 Z-4.1615 K-10"), std::string::npos) << rewritten.text;
  EXPECT_NE(rewritten.text.find("\nG17 G2 X0 Y5 R20\n"), std::string::npos) << rewritten.text;
  EXPECT_EQ(rewritten.replaced, 1u);
}

TEST(TheModalMotionBehindARun, IsWhatTheNextLineExpects) {
  const std::string head = "G21 G90 G94\nG0 X20 Y0\nG1 F600\n", arc = chords(20, 0, 2, 300);
  const auto rewritten = written_again(head + arc + "X0 Y0 (back)\nM2\n");
  EXPECT_NE(rewritten.text.find("\nG1\nX0 Y0 (back)\nM2\n"), std::string::npos) << rewritten.text;
  EXPECT_EQ(rewritten.replaced, 1u);
  EXPECT_EQ(written_again(head + arc + "G1 X0 Y0 (back)\nM2\n").text.find("\nG1\n"), std::string::npos);
}

TEST(Corners, StayCorners) {
  // Sides of 0.02 mm pieces: an arc across the corner would be within 0.01 mm of it.
  std::string text = "G21 G90 G94\nG0 X0 Y0\nG1 F600\n";
  for (int k = 1; k <= 100; ++k) text += fmt::format("X{:.2f} Y0\n", 0.02 * k);
  for (int k = 1; k <= 100; ++k) text += fmt::format("X2 Y{:.2f}\n", 0.02 * k);
  EXPECT_EQ(written_again(text + "M2\n").text, "G21 G90 G94\nG0 X0 Y0\nG1 F600\nX2\nY2\nM2\n");
}

TEST(ATextInDos, KeepsItsLineEnds) {
  std::string text = "G21 G90 G94\r\nG1 F600 X0\r\n";
  for (int k = 1; k <= 50; ++k) text += fmt::format("X{:.2f}\r\n", 0.1 * k);
  EXPECT_EQ(written_again(text + "G0 Z5\r\nM2\r\n").text, "G21 G90 G94\r\nG1 X5 F600\r\nG0 Z5\r\nM2\r\n");
}

TEST(Feeds, StayWhereTheyAre) {
  std::string text = "G21 G90 G94\nG0 X0\n";
  for (int k = 1; k <= 20; ++k) text += fmt::format("G1 X{:.1f} F{}\n", 0.1 * k, k <= 10 ? 600 : 300);
  EXPECT_EQ(written_again(text + "M2\n").text, "G21 G90 G94\nG0 X0\nG1 X1 F600\nX2 F300\nM2\n");
}

TEST(LineNumbers, AreThoseOfTheLastRowThatABlockStandsFor) {
  std::string text = "G21 G90 G94\nG0 X0\nN10G1X.1F600\n";
  for (int k = 2; k <= 10; ++k) text += fmt::format("N{}X{:.1f}\n", 10 * k, 0.1 * k);
  EXPECT_EQ(written_again(text + "M2\n").text, "G21 G90 G94\nG0 X0\nN100G1X1F600\nM2\n");
}

TEST(FanucNumbers, KeepTheirPoints) {
  std::string text = "O1\nG21 G90 G94\nG0 X0. Y0.\nG1 X1. F600.\n";
  for (int k = 2; k <= 10; ++k) text += fmt::format("X{}.\n", k);
  EXPECT_NE(written_again(text + "M30\n", {}, Dialect::fanuc).text.find("\nG1 X10. F600.\n"), std::string::npos);
}

/// Ten pieces of a line, between two texts.
std::string pieces(const std::string& head, const std::string& tail, const std::string& words = "") {
  std::string text = head;
  for (int k = 1; k <= 10; ++k) text += fmt::format("G1 X{:.1f}{}\n", 0.1 * k, words);
  return text + tail + "M2\n";
}

TEST(WhatTextAndMotionDoNotTellAlike, IsLeftAlone) {
  const std::string head = "G21 G90 G94 F600\n";
  for (const std::string& text : {
           pieces(head + "G91\n", "G90\n"),
           pieces(head + "G93\n", "G94\n", " F60"),
           pieces(head + "M3 S1000 G95 F0.1\n", "G94\n"),
           pieces(head + "G10 L2 P1 R30\n", ""),
           pieces(head + "G7\n", "G8\n"),
           pieces(head, "", " A#1"),
           pieces(head, "", " (piece)"),
           pieces(head, "", " M8"),
           pieces(head + "T1 M6\nG41.1 D0.1\n", "G40\n"),
           pieces(head + "o1 repeat [2]\nG0 X0\n", "o1 endrepeat\n"),
       }) {
    const auto rewritten = written_again(text);
    EXPECT_EQ(rewritten.text, text);
    EXPECT_EQ(rewritten.max_deviation, 0.0);
  }
}

TEST(WorkOffsetsAndTools, AreNoHindrance) {
  const auto rewritten =
      written_again(pieces("G20 G90 G94 F60\nG10 L2 P2 X3.1 Y1 Z-2\nG55\nG43.1 Z1.5\nG92 X1\nG0 X0 Y0\n", "G49\n"));
  EXPECT_NE(rewritten.text.find("G0 X0 Y0\nG1 X1\nG49\n"), std::string::npos) << rewritten.text;
}

TEST(ASubprogramThatIsCalledOnce, IsWrittenAgain) {
  const auto rewritten = written_again(pieces("G21 G90 G94 F600\no1 sub\nG0 X0\n", "o1 endsub\no1 call\n"));
  EXPECT_NE(rewritten.text.find("G0 X0\nG1 X1\no1 endsub\n"), std::string::npos) << rewritten.text;
}

TEST(WhatWasWrittenAgain, StaysAsItIs) {
  std::string text = "G21 G90 G94\nG0 X20 Y0\nG1 F600\n" + chords(20, 0, 2, 300);
  for (int k = 1; k <= 200; ++k) text += fmt::format("X{:.4f} Y{:.4f}\n", -8.3 - 0.1 * k, 18.2 + std::sin(0.07 * k));
  const std::string once = written_again(text + "M2\n").text;
  EXPECT_EQ(written_again(once).text, once);
}

TEST(AProgramWithErrors, IsRefused) {
  const std::string text = "G1 X1\nM2\n";  // no feed
  const auto reading = read_text(text, "a.ngc");
  ASSERT_TRUE(reading && reading->refused);
  const auto rewritten = rewrite(text, "a.ngc", *reading, {});
  ASSERT_FALSE(rewritten);
  EXPECT_EQ(rewritten.error().code, "program-refused");
}

}  // namespace
}  // namespace toolpace
