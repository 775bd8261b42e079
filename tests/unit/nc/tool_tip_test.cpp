#include "reading_test_support.h"

#include <Eigen/Core>

#include "../kinematics/chains.h"
#include "toolpace/kinematics/inverse.h"

namespace toolpace::nc {
namespace {

using toolpace::testing::head_and_table;
using toolpace::testing::kB;
using toolpace::testing::kC;
using toolpace::testing::trunnion;

ReadOptions on(Chain chain, bool tells_length = true) {
  ReadOptions options;
  options.dialect = Dialect::fanuc;
  options.integers = IntegerWords::lengths;
  options.kinematics = {std::move(chain), tells_length};
  return options;
}

double degrees(const Moves& moves, std::size_t row, std::size_t axis) {
  return moves.end[row][static_cast<Eigen::Index>(axis)] / kRadiansPerDegree;
}

TEST(ToolTip, FromG43Point4ToG49RowsTellTheTip) {
  const Reading r =
      read_program("G90 G21 G94\nG0 X10 B30 C40\nG43.4 H1\nG1 X5 Y6 Z7 F600\nG49\nG0 Z50\nM30\n", on(head_and_table()));
  ASSERT_FALSE(r.refused) << codes(r).front();
  const Moves& m = r.moves;
  ASSERT_EQ(m.size(), 4u);
  ASSERT_EQ(m.chains.size(), 2u);
  EXPECT_EQ(m.chain_of(0), 0);
  EXPECT_EQ(m.chain_of(1), 1);
  EXPECT_EQ(m.chain_of(2), 0);
  EXPECT_EQ(xyz(m, 1), (std::vector<double>{5, 6, 7}));
  // Where the row begins is the same place, told about the tip.
  const ToolPose pose = forward(m.chains[1], m.end[0]);
  EXPECT_LT((m.begin_of(1).head<3>() - pose.tip).norm(), 1e-12);
  // Behind G49 the axes stand where the tip has taken them, but for Z.
  const AxisVector axes = axes_at(m.chains[1], {5, 6, 7}, m.end[1]);
  EXPECT_NEAR(m.end[2][0], axes[0], 1e-12);
  EXPECT_NEAR(m.end[2][1], axes[1], 1e-12);
  EXPECT_EQ(m.end[2][2], 50);
}

TEST(ToolTip, AWordThatIsNotGivenKeepsTheTipAndNotTheAxes) {
  const Reading r = read_program("G90 G21 G94\nG0 X100 A-30 C20\nG43.4 H1\nG1 Z5 F600\nM30\n", on(trunnion()));
  const Moves& m = r.moves;
  const ToolPose before = forward(m.chains[1], m.end[0]);
  EXPECT_NEAR(m.end[1][0], before.tip[0], 1e-12);
  EXPECT_NEAR(m.end[1][1], before.tip[1], 1e-12);
  EXPECT_EQ(m.end[1][2], 5);
}

TEST(ToolTip, WorkOffsetsAreTheWorkpieces) {
  ReadOptions options = on(head_and_table());
  options.work_offsets = {{1, {10, 20, 30, 0, 0, 0}}};
  const Reading r = read_program("G90 G21 G94 G54\nG43.4 H1\nG1 X1 Y2 Z3 B10 F600\nM30\n", options);
  EXPECT_EQ(xyz(r.moves, 0), (std::vector<double>{11, 22, 33}));
}

TEST(ToolTip, TheLengthIsTheToolsWhereTheMachineTellsNone) {
  const Reading r = read_program("G10 L10 P3 R70\nG90 G21 G94\nG43.4 H3\nG1 X1 F600\nG43.4 H3\nX2\nM30\n",
                                 on(head_and_table(), false));
  ASSERT_FALSE(r.refused) << codes(r).front();
  ASSERT_EQ(r.moves.chains.size(), 2u);
  EXPECT_EQ(r.moves.chains[1].tool_length, 70);
  const Reading missing = read_program("G43.4 H3\nM30\n", on(head_and_table(), false));
  EXPECT_EQ(codes(missing).front(), "tool-length-missing@1:1");
  // A table does not swing the tool.
  EXPECT_FALSE(read_program("G43.4 H3\nM30\n", on(trunnion(), false)).refused);
}

TEST(ToolTip, WithoutKinematicsTheRemedyIsNamed) {
  for (const char* code : {"G43.4 H1", "G43.5 H1"}) {
    const Reading r = read_program(std::string("G90\n") + code + "\nM30\n", {.dialect = Dialect::fanuc});
    EXPECT_TRUE(r.refused);
    EXPECT_EQ(codes(r).front(), "kinematics-missing@2:1");
    EXPECT_NE(r.diagnostics.front().remedy.find("[kinematics]"), std::string::npos);
  }
}

TEST(ToolTip, HaasHasItAsG234) {
  ReadOptions options = on(trunnion());
  options.dialect = Dialect::haas;
  const Reading r = read_program("G90 G21 G94\nG234 H1\nG1 X1 F600\nG49\nM30\n", options);
  ASSERT_FALSE(r.refused) << codes(r).front();
  EXPECT_EQ(r.moves.chain_of(0), 1);
}

TEST(ToolTip, VectorsPointTheTool) {
  // Rz(−C)·Ry(B)·z = (cos C·sin B, −sin C·sin B, cos B): to (0, 1, 1) B is 45 and C −90.
  const Reading r =
      read_program("G90 G21 G94\nG43.5 H1\nG1 X1 I0 J1 K1 F600\nX2\nI1 J0 K1\nM30\n", on(head_and_table()));
  ASSERT_FALSE(r.refused) << codes(r).front();
  const Moves& m = r.moves;
  EXPECT_NEAR(degrees(m, 0, kB), 45, 1e-9);
  EXPECT_NEAR(degrees(m, 0, kC), -90, 1e-9);
  EXPECT_EQ(m.end[1].tail<3>(), m.end[0].tail<3>()) << "what is not given stays";
  EXPECT_NEAR(degrees(m, 2, kC), 0, 1e-9);
  EXPECT_EQ(m.end[2][0], 2);
}

TEST(ToolTip, AtThePoleCStaysAsItIs) {
  const Reading r = read_program("G90 G21 G94\nG43.5 H1\nG1 X1 I1 J1 K1 F600\nX2 I0 J0 K1\nX3 I-1 J-1 K1\nM30\n",
                                 on(head_and_table()));
  const Moves& m = r.moves;
  EXPECT_NEAR(degrees(m, 0, kC), -45, 1e-9);
  EXPECT_EQ(m.end[1][5], m.end[0][5]) << "C is free";
  EXPECT_NEAR(degrees(m, 1, kB), 0, 1e-9);
  EXPECT_NEAR(degrees(m, 2, kC), -45, 1e-9) << "beyond the pole by B the other way, not by half a turn of C";
  EXPECT_LT(degrees(m, 2, kB), 0);
}

TEST(ToolTip, TheTravelIsKeptAndALongWayIsToldOf) {
  ReadOptions options = on(head_and_table());
  options.travel.low[kB] = 0;
  options.travel.low[kC] = -170 * kRadiansPerDegree;
  options.travel.high[kC] = 170 * kRadiansPerDegree;
  const Reading r = read_program("G90 G21 G94\nG43.5 H1\nG1 X1 I-1 J0.2 K1 F600\nX2 I-1 J-0.2 K1\nM30\n", options);
  ASSERT_FALSE(r.refused) << codes(r).front();
  EXPECT_TRUE(has_code(r, "rotary-unwinds"));
  EXPECT_EQ(r.diagnostics.front().where.line, 4u);
  for (std::size_t row = 0; row < 2; ++row) EXPECT_LE(std::abs(degrees(r.moves, row, kC)), 170);
  options.travel.high[kB] = 20 * kRadiansPerDegree;
  const Reading beyond = read_program("G90 G21 G94\nG43.5 H1\nG1 X1 I1 K1 F600\nM30\n", options);
  EXPECT_EQ(codes(beyond).front(), "rotary-travel@3:7");
}

TEST(ToolTip, WhatMakesNoSenseIsRefused) {
  const auto first = [](const std::string& block) {
    const Reading r = read_program("G90 G21 G94 F600\nG43.5 H1\n" + block + "\nM30\n", on(trunnion()));
    return r.diagnostics.empty() ? std::string("nothing") : codes(r).front();
  };
  EXPECT_EQ(first("G1 X1 I0 J0 K0"), "tool-vector-zero@3:7");
  EXPECT_EQ(first("G1 X1 A5 K1"), "tool-vector-with-angles@3:10");
  EXPECT_EQ(first("G53 G0 Z0"), "machine-coordinates-under-tip@3:1");
  EXPECT_EQ(first("G28 Z0"), "machine-coordinates-under-tip@3:1");
  EXPECT_EQ(first("G68.2 X0 Y0 Z0 I0 J0 K0"), "g-code-unfollowed@3:1");
  EXPECT_EQ(first("G49\nG28 Z0"), "nothing");
}

TEST(ToolTip, AWholeProgramMayBeAboutIt) {
  ReadOptions options = on(head_and_table());
  options.dialect = Dialect::linuxcnc;
  options.about_tip = true;
  const Reading r = read_program("G90 G21 G94\nG43 H1\nG1 X1 Y2 Z3 B90 F600\nG53 G0 Z50\nG49\nG0 X0\nM2\n", options);
  ASSERT_FALSE(r.refused) << codes(r).front();
  for (std::size_t row = 0; row < r.moves.size(); ++row) EXPECT_EQ(r.moves.chain_of(row), 1) << row;
  EXPECT_EQ(xyz(r.moves, 1), (std::vector<double>{1, 2, 50}));
  options.kinematics = {};
  EXPECT_EQ(codes(read_program("G90\nM2\n", options)).front(), "kinematics-missing@1:0");
}

TEST(ToolTip, APolylineMayBeAboutIt) {
  ReadOptions options = on(head_and_table());
  options.about_tip = true;
  const Reading r = read_program("x_mm,y_mm,z_mm,b_deg\n0,0,0,90\n10,0,0,90\n", options, "p.csv");
  ASSERT_FALSE(r.refused);
  EXPECT_EQ(r.moves.chain_of(0), 1);
  EXPECT_LT((r.moves.begin_of(0) - toolpace::testing::axes(0, 0, 0, 0, 90)).norm(), 1e-12);
}

TEST(ToolTip, OtherControllersWaysOfItNameWhatIsRead) {
  for (const char* text : {"N10 TRAORI\nN20 G1 X1 B5 F100\nM30\n", "0 BEGIN PGM A MM\n1 M128\n"}) {
    const auto reading = read_text(text, "a.mpf", {});
    ASSERT_FALSE(reading);
    EXPECT_NE(reading.error().remedy.find("G43.4"), std::string::npos) << text;
  }
  const Reading r = read_program("G0 X1 B5\nM128\nM30\n", {}, "a.nc");
  EXPECT_TRUE(r.refused);
}

}  // namespace
}  // namespace toolpace::nc
