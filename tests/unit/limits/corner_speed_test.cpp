#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "toolpace/limits/limit_speed.h"

namespace toolpace {
namespace {

AxisVector direction(double degrees) {
  AxisVector u = AxisVector::Zero();
  u[0] = std::cos(degrees * kRadiansPerDegree);
  u[1] = std::sin(degrees * kRadiansPerDegree);
  return u;
}

Machine machine_with(double path_acceleration, double period) {
  Machine machine;
  machine.path.acceleration = path_acceleration;
  machine.period = period;
  return machine;
}

CornerOptions rule(CornerRule r) {
  CornerOptions corner;
  corner.rule = r;
  return corner;
}

// 90° from X to Y: each axis steps by V, the velocity vector by √2·V. The angle rule 2V·sin 45° ≤ a·Ts is the tighter
// one.
TEST(CornerSpeed, ServoRuleAtARightAngle) {
  const Machine machine = machine_with(3000, 0.004);
  EXPECT_NEAR(corner_speed(rule(CornerRule::servo), direction(0), direction(90), machine), 12 / std::sqrt(2), 1e-12);
}

TEST(CornerSpeed, ServoRuleKeepsASlowAxisInsideItsOwnAcceleration) {
  Machine machine = machine_with(3000, 0.004);
  machine.axes[1].acceleration = 500;  // Y steps by V·sin 30° = V/2 ≤ 500·0.004
  EXPECT_NEAR(corner_speed(rule(CornerRule::servo), direction(0), direction(30), machine), 4.0, 1e-12);
}

TEST(CornerSpeed, StraightOnIsUnbounded) {
  const Machine machine = machine_with(3000, 0.004);
  for (const CornerRule r : {CornerRule::servo, CornerRule::junction, CornerRule::blend, CornerRule::smooth}) {
    EXPECT_EQ(corner_speed(rule(r), direction(20), direction(20), machine), kUnlimited);
  }
}

TEST(CornerSpeed, ExactStopStopsEvenStraightOn) {
  EXPECT_EQ(corner_speed(rule(CornerRule::stop), direction(20), direction(20), machine_with(3000, 0.004)), 0.0);
}

TEST(CornerSpeed, StepRuleUsesTheVectorNorm) {
  CornerOptions corner;
  corner.step = 0.739;
  EXPECT_NEAR(corner_speed(corner, direction(0), direction(90), machine_with(3000, 0.004)), 0.739 / std::sqrt(2),
              1e-14);
}

// δ = 0.01, 90°: V² = a·δ·cos 45°/(1 − cos 45°) = 3000·0.01·2.41421…
TEST(CornerSpeed, JunctionDeviationAtARightAngle) {
  const double ratio = std::sqrt(0.5) / (1 - std::sqrt(0.5));
  EXPECT_NEAR(corner_speed(rule(CornerRule::junction), direction(0), direction(90), machine_with(3000, 0.004)),
              std::sqrt(3000 * 0.01 * ratio), 1e-9);
}

TEST(CornerSpeed, ReversalStopsUnderJunctionDeviation) {
  EXPECT_NEAR(corner_speed(rule(CornerRule::junction), direction(0), direction(180), machine_with(3000, 0.004)), 0,
              1e-3);
}

TEST(CornerSpeed, ARotaryAxisThatSetsInIsAStepToo) {
  Machine machine = machine_with(3000, 0.001);
  machine.axes[3].acceleration = 20;  // rad/s²
  AxisVector with_rotary = direction(0);
  with_rotary[3] = 0.1;  // rad per mm
  EXPECT_NEAR(corner_speed(rule(CornerRule::servo), direction(0), with_rotary, machine), 20 * 0.001 / 0.1, 1e-12);
}

}  // namespace
}  // namespace toolpace
