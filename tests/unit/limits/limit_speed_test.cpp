#include "toolpace/limits/limit_speed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "toolpace/path/build_path.h"

namespace toolpace {
namespace {

AxisVector at(double x, double y, double z = 0) {
  AxisVector p = AxisVector::Zero();
  p.head<3>() << x, y, z;
  return p;
}

void add(Moves& moves, MoveKind kind, const AxisVector& end, double feed, std::uint16_t mode = 0) {
  moves.kind.push_back(kind);
  moves.line.push_back(static_cast<std::uint32_t>(moves.size()));
  moves.file.push_back(0);
  moves.mode.push_back(mode);
  moves.detail.push_back(kNoDetail);
  moves.end.push_back(end);
  moves.feed.push_back(feed);
}

Machine default_machine() {
  Machine machine;
  machine.path = {100, 3000, 3000, 1e6, 1e6};
  return machine;
}

SpeedLimits limits_of(const Moves& moves, const Machine& machine, const LimitOptions& options = {},
                      double feed_override = 1.0) {
  const auto path = build_path(moves, 0);
  CommandOptions command = command_options(machine);
  command.feed_override = feed_override;
  command.rapid_override = options.rapid_override;
  const auto limits = limit_speed(*path, command_path(*path, moves, command), machine, options);
  EXPECT_TRUE(limits) << limits.error().message;
  return limits.value_or(SpeedLimits{});
}

TEST(LimitSpeed, FeedIsCappedByThePathAndOverrideScalesIt) {
  Moves moves;
  add(moves, MoveKind::feed, at(10, 0), 40);
  add(moves, MoveKind::feed, at(20, 0), 400);
  add(moves, MoveKind::rapid, at(30, 0), 0);
  LimitOptions options;
  options.rapid_override = 0.25;
  const SpeedLimits limits = limits_of(moves, default_machine(), options, 0.5);
  EXPECT_EQ(limits.block_cap[0], 20);
  EXPECT_EQ(limits.block_cap[1], 100);
  EXPECT_EQ(limits.block_cap[2], 25);
  EXPECT_EQ(limits.block_cause[0], Cause::feed);
  EXPECT_EQ(limits.block_cause[1], Cause::path_speed);
  EXPECT_EQ(limits.block_cause[2], Cause::rapid);
}

// A cubic with a simple knot in the middle, where it has one derivative: through it at full feed, unless that derivative is
// zero, as by symmetry on the way 0, 1, 2, 1, 0, and the curve turns back.
TEST(LimitSpeed, SplinesRunThroughTheirKnotsButStopWhereTheyTurnBack) {
  for (const bool turns : {false, true}) {
    SplineDetail spline;
    spline.degree = 3;
    for (int k = 0; k < 5; ++k) spline.points.emplace_back(turns && k > 2 ? 4 - k : k, 0.0, 0.0);
    spline.knots = {0, 0, 0, 0, 1, 2, 2, 2, 2};
    Moves moves;
    add(moves, MoveKind::spline, at(spline.points.back().x(), 0), 50);
    moves.detail[0] = 0;
    moves.splines = {spline};
    LimitOptions options;
    options.corner.rule = CornerRule::blend;
    const SpeedLimits limits = limits_of(moves, default_machine(), options);
    double lowest = 1e9;
    for (std::size_t i = 1; i < limits.size(); ++i) lowest = std::min(lowest, limits.node_cap[i]);
    ASSERT_GT(limits.size(), 1u);
    EXPECT_EQ(lowest, turns ? 0.0 : 50.0);
  }
}

TEST(LimitSpeed, AnAxisCapsTheBlocksThatUseIt) {
  Moves moves;
  add(moves, MoveKind::feed, at(30, 0, 40), 90);
  Machine machine = default_machine();
  machine.axes[2].speed = 20;
  machine.axes[2].acceleration = 400;
  machine.axes[2].jerk = 8000;
  const SpeedLimits limits = limits_of(moves, machine);
  EXPECT_DOUBLE_EQ(limits.block_cap[0], 25);
  EXPECT_EQ(limits.block_cause[0], Cause::axis_speed);
  EXPECT_DOUBLE_EQ(limits.dynamics_of(0).up.acceleration, 500);
  EXPECT_DOUBLE_EQ(limits.dynamics_of(0).down.jerk, 10000);
}

// A degree counts as much as a millimetre, and an axis without limits of its own takes the path's.
TEST(LimitSpeed, RotaryAxesTurnBackLikeLinearOnes) {
  for (const CornerRule rule : {CornerRule::servo, CornerRule::junction}) {
    LimitOptions options;
    options.corner.rule = rule;
    double cap[2];
    for (const Eigen::Index axis : {0, 3}) {
      const double unit = axis == 3 ? kRadiansPerDegree : 1.0;
      AxisVector there = AxisVector::Zero();
      there[axis] = 90 * unit;
      Moves moves;
      add(moves, MoveKind::feed, there, 60 * unit);
      add(moves, MoveKind::feed, AxisVector::Zero(), 60 * unit);
      const SpeedLimits limits = limits_of(moves, default_machine(), options);
      cap[axis == 3] = limits.node_cap[1];
      EXPECT_NEAR(limits.block_cap[0], 60, 1e-9);
    }
    EXPECT_LT(cap[0], 2);
    EXPECT_NEAR(cap[1], cap[0], 1e-9 * cap[0]);
  }
}

TEST(LimitSpeed, BlocksWithTheSameLimitsShareThem) {
  Moves moves;
  for (int i = 1; i <= 100; ++i) add(moves, MoveKind::feed, at(i, i % 2), 50);
  EXPECT_EQ(limits_of(moves, default_machine()).dynamics.size(), 1u);
}

TEST(LimitSpeed, EndsAndPausesRest) {
  Moves moves;
  moves.dwells = {0.1};
  add(moves, MoveKind::feed, at(1, 0), 50);
  add(moves, MoveKind::dwell, at(1, 0), 0);
  moves.detail.back() = 0;
  add(moves, MoveKind::feed, at(2, 0), 50);
  const SpeedLimits limits = limits_of(moves, default_machine());
  ASSERT_EQ(limits.node_cap.size(), 3u);
  EXPECT_EQ(limits.node_cap[0], 0);
  EXPECT_EQ(limits.node_cap[1], 0);
  EXPECT_EQ(limits.node_cap[2], 0);
}

TEST(LimitSpeed, ExactStopModeInTheProgramStops) {
  Moves moves;
  moves.modes.push_back({PathControl::exact_stop, 0, 0, 17, 94});
  add(moves, MoveKind::feed, at(1, 0), 50, 1);
  add(moves, MoveKind::feed, at(2, 0), 50, 0);
  add(moves, MoveKind::feed, at(3, 0), 50, 0);
  const SpeedLimits limits = limits_of(moves, default_machine());
  EXPECT_EQ(limits.node_cap[1], 0);
  EXPECT_EQ(limits.node_cap[2], 50);
}

// The path's limits are each axis' too: v²/r takes of 3000 what is then missing along the path.
TEST(LimitSpeed, WithoutAxisLimitsAnArcIsCappedByThePathsAcceleration) {
  Moves moves;
  moves.start = at(1, 0);
  add(moves, MoveKind::arc, at(-1, 0), 90);
  moves.arcs = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), 3.14159265358979}};
  moves.detail.back() = 0;
  const SpeedLimits limits = limits_of(moves, default_machine());
  EXPECT_LE(limits.block_cap[0] * limits.block_cap[0] / 1.0, 3000.0 * (1 + 1e-12));
  EXPECT_EQ(limits.block_cause[0], Cause::curvature);
  EXPECT_LE(limits.dynamics_of(0).up.acceleration, 0.2 * 3000);
  ASSERT_EQ(limits.curved, std::vector<std::uint32_t>{0});
  ASSERT_EQ(limits.budget.size(), 1u);
  EXPECT_NEAR(limits.budget[0].row[0].across, 1 / 3000.0, 1e-15);
  EXPECT_NEAR(limits.budget[0].row[0].jerk, 1e-6, 1e-18);
}

TEST(LimitSpeed, NothingThatBoundsTheSpeedIsAUsageError) {
  Moves moves;
  add(moves, MoveKind::rapid, at(1, 0), 0);
  const auto path = build_path(moves, 0);
  Machine machine;
  machine.path.acceleration = machine.path.deceleration = 100;
  const auto limits = limit_speed(*path, command_path(*path, moves, command_options(machine)), machine, {});
  ASSERT_FALSE(limits);
  EXPECT_EQ(limits.error().kind, ErrorKind::usage);
  EXPECT_EQ(limits.error().code, "no-speed-limit");
  EXPECT_EQ(limits.error().message,
            "--vmax (max_speed_mm_s in [path]) is inf, and nothing else bounds the speed in line 1");
}

TEST(LimitSpeed, TheDirectionThatNothingBoundsIsNamed) {
  Moves moves;
  add(moves, MoveKind::feed, at(1, 0), 10);
  const auto path = build_path(moves, 0);
  Machine machine;
  machine.path.speed = machine.path.acceleration = 100;
  const auto limits = limit_speed(*path, command_path(*path, moves, command_options(machine)), machine, {});
  ASSERT_FALSE(limits);
  EXPECT_EQ(limits.error().code, "no-acceleration-limit");
  EXPECT_EQ(limits.error().message,
            "--dm (max_deceleration_mm_s2 in [path]) is inf, and nothing else bounds the deceleration in line 1");
}

}  // namespace
}  // namespace toolpace
