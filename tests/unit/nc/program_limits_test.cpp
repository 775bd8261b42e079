/// What programs set of speeds and accelerations, and of overrides.

#include "reading_test_support.h"

namespace toolpace::nc {
namespace {

const MotionCeiling& ceiling_of(const Reading& reading, std::size_t row) {
  const Moves& moves = reading.moves;
  return moves.ceilings[moves.modes[moves.mode[row]].ceiling];
}

TEST(ProgramLimits, OfPrintersHoldFromThereOn) {
  const auto reading = read_as(Dialect::marlin,
                               "G21 G90\nG1 X1 F600\nM201 X500 Y400 E5000\nM203 X100 Z10\nG1 X2\n"
                               "M205 X8 Y7 J0.02\nG1 X3\nM84\n");
  EXPECT_EQ(ceiling_of(reading, 0), MotionCeiling{});
  const MotionCeiling& second = ceiling_of(reading, 1);
  EXPECT_EQ(second.acceleration[0], 500);
  EXPECT_EQ(second.acceleration[1], 400);
  EXPECT_EQ(second.acceleration[2], MotionCeiling::kNone);
  EXPECT_EQ(second.speed[0], 100);
  EXPECT_EQ(second.speed[2], 10);
  EXPECT_FALSE(second.limits_corners());
  const MotionCeiling& third = ceiling_of(reading, 2);
  EXPECT_EQ(third.corner_step[0], 8);
  EXPECT_EQ(third.corner_step[1], 7);
  EXPECT_EQ(third.junction_deviation, 0.02);
  EXPECT_EQ(third.speed[0], 100);
}

TEST(ProgramLimits, PrintsAndTravelsHaveTheirOwnAcceleration) {
  const auto reading = read_as(Dialect::marlin,
                               "G21 G90\nM204 P800 T1500\nG1 X1 E1 F600\nG1 X2\nG1 X3 E2\n"
                               "M204 S300\nG1 X4 E3\nG0 X5\n");
  std::vector<double> accelerations;
  for (std::size_t row = 0; row < 5; ++row) accelerations.push_back(ceiling_of(reading, row).path_acceleration);
  EXPECT_EQ(accelerations, (Values{800, 1500, 800, 300, 300}));
  EXPECT_EQ(reading.moves.ceilings.size(), 4u);  // the third lowers nothing, before the first M204
}

TEST(ProgramLimits, OfKlipperAreReadAndWhatHasNoEffectIsToldOnce) {
  const auto reading = read_as(Dialect::marlin,
                               "G21 G90\nSET_VELOCITY_LIMIT VELOCITY=80 ACCEL=500 ACCEL_TO_DECEL=250\nG1 X1 F600\n"
                               "set_velocity_limit square_corner_velocity=5 MINIMUM_CRUISE_RATIO=0.5\nG1 X2\n");
  EXPECT_EQ(ceiling_of(reading, 0).path_speed, 80);
  EXPECT_EQ(ceiling_of(reading, 0).path_acceleration, 500);
  EXPECT_EQ(ceiling_of(reading, 1).corner_speed, 5);
  EXPECT_EQ(ceiling_of(reading, 1).path_acceleration, 500);
  EXPECT_EQ(codes(reading), (Codes{"limit-without-effect@2:42"}));
}

TEST(ProgramLimits, ThatNothingCouldMoveUnderAreLeftOut) {
  const auto reading = read_as(Dialect::marlin, "M204 S0\nM203 X-1\nG1 X1 F600\n");
  EXPECT_EQ(codes(reading), (Codes{"limit-not-positive@1:6", "limit-not-positive@2:6"}));
  EXPECT_EQ(ceiling_of(reading, 0), MotionCeiling{});
}

TEST(ProgramLimits, AccelerationsAreNoToolsAndNoSpindleSpeeds) {
  const auto reading = read_as(Dialect::marlin, "G21 G90\nS1000 M3\nM204 S800 T1500\nG1 X1 F600\n");
  EXPECT_FALSE(reading.refused);
  EXPECT_EQ(reading.modal.at(4)->spindle_speed, 1000);
}

TEST(Overrides, AreHeldBetweenM49AndM48) {
  for (const Dialect dialect : {Dialect::linuxcnc, Dialect::fanuc, Dialect::mach3}) {
    const auto reading = read_as(dialect, "G21 G90 G94\nG1 X1. F600\nM49\nX2.\nM48\nX3.\nM2\n");
    EXPECT_FALSE(ceiling_of(reading, 0).holds_overrides);
    EXPECT_TRUE(ceiling_of(reading, 1).holds_overrides);
    EXPECT_FALSE(ceiling_of(reading, 2).holds_overrides);
    EXPECT_TRUE(codes(reading).empty()) << codes(reading).front();
  }
  const auto feed = read_as(Dialect::linuxcnc, "G21 G90 G94 F600\nM50 P0\nG1 X1\nM50 P1\nX2\nM51 P0\nX3\nM2\n");
  EXPECT_TRUE(ceiling_of(feed, 0).holds_overrides);
  EXPECT_FALSE(ceiling_of(feed, 1).holds_overrides);
  EXPECT_FALSE(ceiling_of(feed, 2).holds_overrides);
}

TEST(Smoothness, OfHaasRoundsCornersByE) {
  const auto reading = read_as(Dialect::haas, "G21 G90 G94\nG187 P3 E0.02\nG1 X1. F600.\nG187\nX2.\nM30\n");
  const auto& modes = reading.moves.modes;
  EXPECT_EQ(modes[reading.moves.mode[0]].control, PathControl::blend);
  EXPECT_EQ(modes[reading.moves.mode[0]].tolerance, 0.02);
  EXPECT_EQ(modes[reading.moves.mode[1]].control, PathControl::job_default);
  EXPECT_EQ(ceiling_of(reading, 0).accuracy, 1);
  EXPECT_EQ(ceiling_of(reading, 1).accuracy, 0);
  EXPECT_TRUE(codes(reading).empty());
  const auto medium = read_as(Dialect::haas, "G21 G90 G94\nG187 P2\nG1 X1. F600.\nM30\n");
  EXPECT_EQ(ceiling_of(medium, 0).accuracy, 0.5);
  EXPECT_EQ(medium.moves.modes[medium.moves.mode[0]].control, PathControl::job_default);
  EXPECT_EQ(codes(read_as(Dialect::haas, "G187 P4\nM30\n")), (Codes{"accuracy-level@1:6"}));
}

TEST(Smoothness, OfFanucHasLevelsAndItsAxisWordsMoveNothing) {
  const auto reading = read_as(Dialect::fanuc,
                               "G21 G90 G94\nG0 X5.\nG5.1 Q1 R10\nG1 X1. F600\nG5.1 Q1 R1\nX2.\nG5.1 Q2 X0 Y0 Z0 R4\n"
                               "X3.\nG5.1 Q0\nX4.\nM30\n");
  EXPECT_EQ(ends(reading), (Values{5, 1, 2, 3, 4}));
  Values accuracies;
  for (std::size_t row = 0; row < 5; ++row) accuracies.push_back(ceiling_of(reading, row).accuracy);
  EXPECT_EQ(accuracies, (Values{0, 1, 0, 3.0 / 9, 0}));
}

}  // namespace
}  // namespace toolpace::nc
