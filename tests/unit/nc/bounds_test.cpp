/// No program, however hostile, runs without end or takes time out of proportion to its length.

#include <fmt/format.h>

#include "reading_test_support.h"

namespace toolpace::nc {
namespace {

TEST(Bounds, EndlessProgramsMeetABound) {
  const ReadLimits small{.call_depth = 5, .loop_turns = 100, .blocks = 50, .lines = 1000};
  const auto code = [&](const std::string& text) {
    return read_program(text, {.limits = small}).diagnostics.at(0).code;
  };
  EXPECT_EQ(code("o1 while [1]\no1 endwhile\nM2\n"), "too-many-turns");
  EXPECT_EQ(code("o1 while [1]\nG91 G0 X1\no1 endwhile\nM2\n"), "too-many-blocks");
  EXPECT_EQ(code("o1 sub\no1 call\no1 endsub\no1 call\nM2\n"), "calls-too-deep");
  EXPECT_EQ(code("G0 Z5\nG81 X1 Z-1 R1 F5 L100000\nM2\n"), "too-many-blocks");
  std::string long_loop = "o1 while [1]\n";
  for (int i = 0; i < 500; ++i) long_loop += "#1=2\n";
  EXPECT_EQ(code(long_loop + "o1 endwhile\nM2\n"), "too-many-lines");
  EXPECT_EQ(
      read_program("%\nN1 #1=2\nGOTO 1\nM30\n%\n", {.dialect = Dialect::fanuc, .limits = small}).diagnostics.at(0).code,
      "too-many-turns");
}

template <class... Columns>
constexpr std::size_t width_of(const Columns&...) {
  return (sizeof(typename Columns::value_type) + ...);
}

TEST(Bounds, BlocksTakeAtMost120Bytes) {
  const Moves m;
  const std::size_t line = width_of(m.kind, m.line, m.file, m.mode, m.detail, m.end, m.feed);
  EXPECT_EQ(line, 69u);
  EXPECT_LE(line + width_of(m.arcs), 120u);
}

TEST(Bounds, NormalsOfEveryPlaneSurviveTheirTwoNumbers) {
  for (const auto& normal :
       {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(-0.6, 0.8, 0)}) {
    EXPECT_EQ(Eigen::Vector3d(PlaneNormal(normal)), normal);
  }
}

TEST(Bounds, BoundsHoldForWhatIsDoneAgainNotForTheLengthOfAProgram) {
  const ReadLimits small{.call_depth = 5, .loop_turns = 100, .blocks = 50, .lines = 100};
  std::string text = "G21\n";
  for (int i = 0; i < 2000; ++i) text += fmt::format("G0 X{} (a comment that makes the line long)\n", i);
  const auto reading = read_program(text + "M2\n", {.limits = small});
  EXPECT_EQ(codes(reading), Codes{});
  EXPECT_EQ(reading.moves.size(), 2001u);
}

TEST(Bounds, EveryBranchAndEveryLongLineCountsTowardsTheBound) {
  const ReadLimits small{.call_depth = 5, .loop_turns = 1'000'000, .blocks = 50, .lines = 10'000};
  const auto code = [&](const std::string& inner) {
    return read_program("o1 while [1]\n" + inner + "o1 endwhile\nM2\n", {.limits = small}).diagnostics.at(0).code;
  };
  std::string branches = "o2 if [0]\n";
  for (int i = 0; i < 1000; ++i) branches += "o2 elseif [0]\n";
  EXPECT_EQ(code(branches + "o2 endif\n"), "too-many-lines");
  EXPECT_EQ(code("#1=[1" + std::string(20'000, ' ') + "]\n"), "too-many-lines");
}

// A long chain of branches, loops around thousands of control words and many equal line numbers once took time
// quadratic in their number.
TEST(Bounds, ControlWordsAreFoundAtOnce) {
  std::string branches = "o1 if [0]\n";
  for (int i = 0; i < 100'000; ++i) branches += "o1 elseif [0]\n";
  EXPECT_EQ(codes(read_program(branches + "o1 endif\nM2\n")), Codes{});
  std::string loop = "o1 while [#1 LT 100000]\n#1=[#1+1]\no2 if [0]\n";
  for (int i = 3; i < 50'000; ++i) loop += fmt::format("o{} if [0]\no{} endif\n", i, i);
  EXPECT_EQ(codes(read_program("#1=0\n" + loop + "o2 endif\no1 continue\no1 endwhile\nM2\n")), Codes{});
  std::string numbers = "O1\nG21\n#1=0\n";
  for (int i = 0; i < 100'000; ++i) numbers += "N1\n";
  const auto jumps = read_program(numbers + "N2 #1=#1+1\nIF[#1LT100000]GOTO2\nM30\n", {.dialect = Dialect::fanuc});
  EXPECT_EQ(codes(jumps), Codes{});
}

TEST(Bounds, ManyTolerancesAreToldApartQuickly) {
  const std::string turn = "#1=0\no2 repeat [60000]\n#1=[#1+1]\nG64 P[#1/10000]\no2 endrepeat\n";
  const auto reading = read_program("o1 repeat [4]\n" + turn + "o1 endrepeat\nM2\n");
  EXPECT_EQ(codes(reading), Codes{});
  EXPECT_EQ(reading.moves.modes.size(), 60'001u);
  const auto more = read_program("#1=0\no2 repeat [70000]\n#1=[#1+1]\nG64 P[#1/10000]\no2 endrepeat\nM2\n");
  EXPECT_EQ(more.diagnostics.at(0).code, "too-many-modes");
}

}  // namespace
}  // namespace toolpace::nc
