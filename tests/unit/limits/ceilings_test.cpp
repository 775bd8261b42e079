#include "toolpace/limits/ceilings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "toolpace/limits/limit_speed.h"
#include "toolpace/nc/reader.h"
#include "toolpace/path/build_path.h"
#include "toolpace/pipeline/job.h"
#include "toolpace/pipeline/prove.h"

namespace toolpace {
namespace {

constexpr double kNone = MotionCeiling::kNone;

AxisVector along(double degrees) {
  AxisVector u = AxisVector::Zero();
  u[0] = std::cos(degrees * kRadiansPerDegree);
  u[1] = std::sin(degrees * kRadiansPerDegree);
  return u;
}

std::shared_ptr<Job> job_of(const std::string& text, Dialect dialect = Dialect::marlin) {
  auto job = std::make_shared<Job>();
  job->program = std::make_shared<const Reading>(read_text(text, "a.gcode", {.dialect = dialect}).value());
  job->machine.path = {100, 3000, 3000, 1e6, 1e6};
  return job;
}

double seconds(const Outcome& outcome, Cause cause) {
  return outcome.summary.time_by_cause[static_cast<std::size_t>(cause)];
}

TEST(Ceilings, LowerTheMachineAndNeverRaiseIt) {
  Machine machine;
  machine.path = {100, 3000, 2000, 1e6, 1e6};
  machine.axes[0].speed = 80;
  MotionCeiling ceiling;
  ceiling.speed[0] = 200;
  ceiling.speed[1] = 50;
  ceiling.acceleration[2] = 10;
  ceiling.path_acceleration = 2500;
  const Machine low = under(machine, ceiling);
  EXPECT_EQ(low.axes[0].speed, 80);
  EXPECT_EQ(low.axes[1].speed, 50);
  EXPECT_EQ(low.axes[2].acceleration, 10);
  EXPECT_EQ(low.path.acceleration, 2500);
  EXPECT_EQ(low.path.deceleration, 2000);
  EXPECT_EQ(low.path.speed, 100);
}

// Levels go from the machine's acceleration to its fine one in proportion; a machine that has none stays as it is.
TEST(Ceilings, OfAccuracyCostAcceleration) {
  Machine machine;
  machine.path = {100, 3000, 2000, 1e6, 1e6, 1000};
  MotionCeiling half, most;
  half.accuracy = 0.5;
  most.accuracy = 1;
  EXPECT_EQ(under(machine, half).path.acceleration, 2000);
  EXPECT_EQ(under(machine, half).path.deceleration, 1500);
  EXPECT_EQ(under(machine, most).path.acceleration, 1000);
  EXPECT_EQ(under(machine, lower_of(half, most)).path.acceleration, 1000);
  EXPECT_EQ(under(machine, higher_of(half, most)).path.acceleration, 2000);
  machine.path.fine_acceleration = 9000;
  EXPECT_EQ(under(machine, most).path.acceleration, 3000);
  machine.path.fine_acceleration = kUnlimited;
  EXPECT_EQ(under(machine, most).path.acceleration, 3000);
}

TEST(ProgramLimitsInPlans, LevelsOfAccuracyCountWhereTheMachineKnowsThem) {
  auto job = job_of("G21 G90 G94\nG5.1 Q1 R10\nG1 X100. F6000\nM30\n", Dialect::fanuc);
  const auto unknown = run(job);
  ASSERT_TRUE(unknown);
  ASSERT_EQ(unknown->warnings.size(), 1u);
  EXPECT_EQ(unknown->warnings[0].code, "limit-without-effect");
  auto known_job = std::make_shared<Job>(*job);
  known_job->machine.path.fine_acceleration = 100;
  const auto known = run(known_job);
  ASSERT_TRUE(known);
  EXPECT_TRUE(known->warnings.empty());
  EXPECT_GE(known->summary.cycle_time, 2 * (1 - 1e-9));
  EXPECT_LT(unknown->summary.cycle_time, 1.2);
}

TEST(Ceilings, LowerAndHigherAreByKind) {
  MotionCeiling a, b;
  a.path_speed = 5;
  b.path_acceleration = 7;
  a.corner_step[1] = 3;
  b.corner_step[1] = 4;
  a.holds_overrides = true;
  const MotionCeiling low = lower_of(a, b), high = higher_of(a, b);
  EXPECT_EQ(low.path_speed, 5);
  EXPECT_EQ(low.path_acceleration, 7);
  EXPECT_EQ(low.corner_step[1], 3);
  EXPECT_TRUE(low.holds_overrides);
  EXPECT_EQ(high.path_speed, kNone);
  EXPECT_EQ(high.path_acceleration, kNone);
  EXPECT_EQ(high.corner_step[1], 4);
  EXPECT_FALSE(high.holds_overrides);
}

// At 90° each axis steps by V; the square corner speed is V itself, and δ = V²(√2 − 1)/a misses the corner by as much.
TEST(Ceilings, OfCornersAsTheFirmwareHasThem) {
  Machine machine;
  machine.path.acceleration = 1000;
  MotionCeiling step, square, deviation;
  step.corner_step.head<2>() << 8, 6;
  square.corner_speed = 5;
  deviation.junction_deviation = 25 * (std::sqrt(2.0) - 1) / 1000;
  EXPECT_NEAR(corner_speed(step, along(0), along(90), machine), 6, 1e-12);
  EXPECT_NEAR(corner_speed(step, along(0), along(180), machine), 4, 1e-12);
  EXPECT_NEAR(corner_speed(square, along(0), along(90), machine), 5, 1e-9);
  EXPECT_NEAR(corner_speed(square, along(0), along(180), machine), 0, 1e-6);
  EXPECT_EQ(corner_speed(square, along(30), along(30), machine), kUnlimited);
  // By the vector in which the velocity turns, here of length √2: 1000 mm/s² are left of the path's in it.
  EXPECT_NEAR(corner_speed(deviation, along(0), along(90), machine), 5, 1e-9);
  EXPECT_EQ(corner_speed(MotionCeiling{}, along(0), along(90), machine), kUnlimited);
}

// 100 mm at 100 mm/s take 1 s and a ramp; at 40 mm/s, or at 100 mm/s² (√(100·100) = 100 mm/s is just reached), more.
TEST(ProgramLimitsInPlans, LowerSpeedAndAccelerationAndAreNamed) {
  for (const LawKind law : {LawKind::trapezoid, LawKind::quintic, LawKind::seven_phase, LawKind::time_optimal}) {
    for (const Ramps ramps : {Ramps::block, Ramps::span}) {
      auto job = job_of("G21 G90\nG1 X100 F6000\nM203 X40\nG1 X200\nM84\n");
      job->options.law = law;
      job->options.ramps = ramps;
      const auto outcome = run(job);
      ASSERT_TRUE(outcome);
      EXPECT_EQ(outcome->limits.block_cap[1], 40);
      EXPECT_EQ(outcome->limits.block_cause[1], Cause::program_limit);
      EXPECT_GT(seconds(*outcome, Cause::program_limit), 2.4);
      EXPECT_GT(seconds(*outcome, Cause::feed), 0.8);
      auto slow = job_of("G21 G90\nM204 S100\nG1 X100 F6000\nM84\n");
      slow->options.law = law;
      slow->options.ramps = ramps;
      const auto ramped = run(slow);
      ASSERT_TRUE(ramped);
      EXPECT_GE(ramped->summary.cycle_time, 2 * (1 - 1e-9));
      EXPECT_LE(ramped->summary.peaks.acceleration, 100 * (1 + 1e-9));
      EXPECT_GT(seconds(*ramped, Cause::program_limit), 1.0);
    }
  }
}

TEST(ProgramLimitsInPlans, NeverAboveTheMachine) {
  const auto free = run(job_of("G21 G90\nG1 X100 F6000\nM84\n"));
  const auto high = run(job_of("G21 G90\nM201 X9000\nM203 X9000\nM204 S9000\nG1 X100 F6000\nM84\n"));
  ASSERT_TRUE(free && high);
  EXPECT_EQ(free->summary.cycle_time, high->summary.cycle_time);
  EXPECT_EQ(seconds(*high, Cause::program_limit), 0);
}

TEST(ProgramLimitsInPlans, HoldOnArcsAndInTheTube) {
  for (const CornerRule rule : {CornerRule::servo, CornerRule::blend, CornerRule::smooth}) {
    auto job = job_of("G21 G90\nM204 S400\nG1 X20 F6000\nG1 Y20\nG3 X0 Y40 I-20 J0\nG1 X-20\nM84\n");
    for (std::size_t k = 0; k < 3; ++k) job->machine.axes[k] = {200, 3000, 1e6};
    job->options.corner.rule = rule;
    const auto outcome = run(job);
    ASSERT_TRUE(outcome);
    const auto report = prove(*outcome);
    ASSERT_TRUE(report);
    EXPECT_TRUE(report->passes());
    EXPECT_LE(outcome->summary.peaks.acceleration, 400 * (1 + 1e-6));
  }
}

TEST(ProgramLimitsInPlans, TheTubeTakesTheLowestAndSaysSo) {
  auto job = job_of("G21 G90\nM204 S400\nG1 X20 F6000\nM204 S900\nG1 Y20\nG1 X40\nM84\n");
  for (std::size_t k = 0; k < 3; ++k) job->machine.axes[k] = {200, 3000, 1e6};
  job->options.corner.rule = CornerRule::smooth;
  const auto outcome = run(job);
  ASSERT_TRUE(outcome);
  const auto count = std::count_if(outcome->warnings.begin(), outcome->warnings.end(),
                                   [](const Diagnostic& d) { return d.code == "limits-change-in-tube"; });
  EXPECT_EQ(count, outcome->plan.splines.empty() ? 0 : 1);
}

TEST(ProgramLimitsInPlans, CornersThatAreRoundedDoNotKeepThem) {
  const std::string text = "G21 G90\nM205 X0.5 Y0.5\nG1 X20 F6000\nG1 Y20\nM84\n";
  const auto crossed = run(job_of(text));
  ASSERT_TRUE(crossed);
  EXPECT_NEAR(crossed->limits.node_cap[1], 0.5, 1e-9);
  EXPECT_TRUE(crossed->warnings.empty());
  auto job = job_of(text);
  job->options.corner.rule = CornerRule::blend;
  const auto rounded = run(job);
  ASSERT_TRUE(rounded);
  ASSERT_FALSE(rounded->warnings.empty());
  EXPECT_EQ(rounded->warnings.back().code, "corner-limit-without-effect");
}

TEST(ProgramLimitsInPlans, HeldOverridesDoNotCount) {
  auto job = job_of("G21 G90 G94 F3000\nG1 X10\nM49\nX20\nG0 X30\nM48\nX40\nM2\n", Dialect::linuxcnc);
  job->options.feed_override = 0.5;
  job->options.rapid_override = 0.25;
  const auto outcome = run(job);
  ASSERT_TRUE(outcome);
  const Commands& commands = *outcome->commands;
  EXPECT_EQ(commands[0].speed, 25);
  EXPECT_EQ(commands[1].speed, 50);
  EXPECT_EQ(commands[2].speed, 100);
  EXPECT_EQ(commands[3].speed, 25);
}

// A plan of the same path without the limits breaks them, and its proof under the program says so.
TEST(ProgramLimitsInPlans, VerificationJudgesByThem) {
  const auto free = run(job_of("G21 G90\nG1 X100 F6000\nM84\n"));
  ASSERT_TRUE(free);
  Outcome claimed = *free;
  claimed.job = job_of("G21 G90\nM203 X40\nM201 X200\nG1 X100 F6000\nM84\n");
  const auto report = prove(claimed);
  ASSERT_TRUE(report);
  EXPECT_FALSE(report->passes());
  std::vector<CheckKind> broken;
  for (const Check& check : report->checks) {
    if (check.broken) broken.push_back(check.kind);
  }
  EXPECT_NE(std::find(broken.begin(), broken.end(), CheckKind::axis_speed), broken.end());
  EXPECT_NE(std::find(broken.begin(), broken.end(), CheckKind::axis_acceleration), broken.end());
}

}  // namespace
}  // namespace toolpace
