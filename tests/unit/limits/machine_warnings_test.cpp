/// What of a program does not fit the machine: axes that it has not, travel that is left.

#include <numbers>

#include "planned_program.h"
#include "toolpace/limits/axes_there.h"
#include "toolpace/limits/travel.h"

namespace toolpace {
namespace {

using namespace testing;

Machine three_axes() {
  Machine machine;
  for (std::size_t k = 0; k < 3; ++k) machine.axes[k].speed = 100;
  return machine;
}

TEST(AxesThere, AreMissedAtTheFirstLineThatMovesThem) {
  Program program;
  program.line(10, 0).rotate(1.0, 1.0).rotate(0.0, 1.0);
  const Path path = build_path(program.moves(), 0).value();
  const Diagnostics warnings = check_axes(path, program.moves(), three_axes());
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].code, "axis-not-there");
  EXPECT_EQ(warnings[0].where.line, program.moves().line[1]);
  EXPECT_NE(warnings[0].message.find("moves A"), std::string::npos);
  EXPECT_NE(warnings[0].remedy.find("[axes.A]"), std::string::npos);
}

TEST(AxesThere, AreNotMissedWhereTheyRestOrNoAxisIsDescribed) {
  Program turning, level;
  turning.rotate(1.0, 1.0);
  level.line(10, 0).arc(0, 0, 2 * std::numbers::pi);
  EXPECT_TRUE(check_axes(build_path(turning.moves(), 0).value(), turning.moves(), Machine{}).empty());
  EXPECT_TRUE(check_axes(build_path(level.moves(), 0).value(), level.moves(), three_axes()).empty());
  Machine no_z = three_axes();
  no_z.axes[2] = {};
  EXPECT_TRUE(check_axes(build_path(level.moves(), 0).value(), level.moves(), no_z).empty());
}

TEST(AxesThere, AreMovedByACircleThatComesBackToItsStart) {
  Program program;
  program.start(10, 0).arc(0, 0, 2 * std::numbers::pi);
  Machine no_y = three_axes();
  no_y.axes[1] = {};
  const Path path = build_path(program.moves(), 0).value();
  ASSERT_EQ(check_axes(path, program.moves(), no_y).size(), 1U);
}

// A circle of 10 mm about (0, 5): Y from −5 to 15.
TEST(Travel, IsLeftByAxisEndAndLine) {
  Program program;
  program.line(12, 5).line(10, 5).arc(0, 5, 2 * std::numbers::pi).line(14, 5);
  Machine machine = three_axes();
  machine.axes[0].travel_max = 11;
  machine.axes[1].travel_min = -3;
  machine.axes[1].travel_max = 15;
  const auto found = find_travel_excess(build_path(program.moves(), 0).value(), machine);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].axis, 0U);
  EXPECT_TRUE(found[0].is_upper);
  EXPECT_NEAR(found[0].excess, 3, 1e-12);
  EXPECT_EQ(found[0].row, 0U);
  EXPECT_EQ(found[0].worst_row, 3U);
  EXPECT_EQ(found[1].axis, 1U);
  EXPECT_FALSE(found[1].is_upper);
  EXPECT_NEAR(found[1].excess, 2, 1e-9);
  EXPECT_EQ(found[1].row, 2U);
  const Diagnostics warnings = check_travel(build_path(program.moves(), 0).value(), program.moves(), machine);
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_EQ(warnings[0].where.line, program.moves().line[0]);
}

}  // namespace
}  // namespace toolpace
