/// What those who begin get wrong: every answer says what is wrong, where, and what to do.

#include "reading_test_support.h"

namespace toolpace::nc {
namespace {

struct Answer {
  const char* text;
  const char* place;  ///< code@line:column of the first diagnostic
  const char* says;   ///< part of its message
  const char* advises;
};

const Answer kAnswers[] = {
    {"G1 X1O Y5 F100\nM2\n", "number-expected@1:6", "word O has no number", "digit 0"},
    {"G1 X1O5 F100\nM2\n", "o-word-misplaced@1:6", "O word", "digit 0"},
    {"GO X10\nM2\n", "number-expected@1:1", "word G has no number", "digit 0"},
    {"G1 Xl0 F100\nM2\n", "number-expected@1:4", "word X has no number", "digit 1"},
    {"G1 X1,5 F100\nM2\n", "bad-character@1:6", "','", "decimal point"},
    {"G1 X,5 F100\nM2\n", "number-expected@1:4", "word X has no number", "decimal point"},
    {"G1 X Y5 F100\nM2\n", "number-expected@1:4", "word X has no number", "behind it"},
    {"G01X\nM2\n", "number-expected@1:4", "word X has no number", "behind it"},
    {"G1 X=5 F100\nM2\n", "number-expected@1:4", "word X has no number", "leave the ="},
    {"G1 X\xE2\x88\x92"
     "10 F100\nM2\n",
     "number-expected@1:4", "U+2212", "plain ASCII"},
    {"G1 X10\xC2\xB0 F100\nM2\n", "bad-character@1:7", "U+00B0", "no unit"},
    {"G1 X1/2 F100\nM2\n", "bad-character@1:6", "'/'", "X[1/2]"},
    {"G21 set units\nM2\n", "number-expected@1:5", "word S has no number", "Comments"},
    {"G21 # units\nM2\n", "number-expected@1:5", "'#'", "comments"},
    {"G21 (units\nM2\n", "comment-not-closed@1:5", "')'", "close"},
    {"G1 X-5 F-100\nM2\n", "feed-negative@1:8", "a feedrate of -100", "below 0"},
    {"G4 X1\nM2\n", "dwell-without-time@1:1", "G4 without a time", "P"},
    {"G18 G81 X1 Z1 R2 F100\nM2\n", "cycle-without-depth@1:5", "without Y", "with Y"},
    {"G2 X10 F100\nM2\n", "arc-incomplete@1:1", "without radius and centre", "I J K"},
    {"G2 X10 R2 F100\nM2\n", "arc-radius-too-small@1:8", "cannot reach", "5.0000 mm"},
    {"o<drill> call\nM2\n", "sub-program-unknown@1:2", "O<drill>", "--sub-path"},
    {"M98 P1000\nM2\n", "sub-program-unknown@1:5", "O1000", "--sub-path"},
    {"o1 endwile\nM2\n", "o-word-unknown@1:3", "O1 is followed by no control word", "endwhile"},
    {"M6\nM2\n", "tool-not-selected@1:1", "without a tool", "T1 M6"},
};

TEST(Beginners, EveryAnswerSaysWhatWhereAndWhatToDo) {
  for (const auto& answer : kAnswers) {
    const auto reading = read_as(Dialect::linuxcnc, answer.text);
    ASSERT_FALSE(reading.diagnostics.empty()) << answer.text;
    const Diagnostic& first = reading.diagnostics.front();
    EXPECT_EQ(codes(reading).front(), answer.place) << answer.text;
    EXPECT_NE(first.message.find(answer.says), std::string::npos) << answer.text << first.message;
    EXPECT_NE(first.remedy.find(answer.advises), std::string::npos) << answer.text << first.remedy;
    EXPECT_FALSE(first.excerpt.empty()) << answer.text;
  }
}

TEST(Beginners, WhatIsOnlyUnusualReadsAsItShould) {
  for (const char* text : {"g21 g90 g1 x10 f100 m2", "G21G90G1X10F100M2\n", "\tG1\tX10\tF100\r\nM2\r\n",
                           "G1 X10 F100\rM2\r", "\xEF\xBB\xBFG1 X10 F100\nM2\n", "%\nG1 X10 F100\n%\n",
                           "G01 X+10. F100\nM02\n", "N10 G1 X10 F100;to the right\nM2;end\n"}) {
    const auto reading = read_program(text);
    EXPECT_EQ(codes(reading), Codes{}) << text;
    EXPECT_EQ(ends(reading), Values{10.0}) << text;
  }
}

TEST(Beginners, OneUnknownSubProgramDoesNotHideWhatFollows) {
  EXPECT_EQ(codes(read_program("o<a> call\nM98 P7\nG1 X\nM2\n")),
            (Codes{"sub-program-unknown@1:2", "sub-program-unknown@2:5", "number-expected@3:4"}));
}

}  // namespace
}  // namespace toolpace::nc
