#include "toolpace/kinematics/inverse.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <random>

#include "chains.h"

namespace toolpace {
namespace {

using Eigen::Vector3d;
using namespace testing;

double degrees(const AxisVector& v, std::size_t axis) { return v[static_cast<Eigen::Index>(axis)] / kRadiansPerDegree; }

// Tool along Y: A = 90°, C = 0 as in chain_test; the other way is A = −90°, C = 180°.
TEST(Inverse, FindsBothWays) {
  const auto ways = rotary_solutions(trunnion(), Vector3d::UnitY(), axes(0, 0, 0, 10));
  ASSERT_TRUE(ways);
  ASSERT_EQ(ways->size(), 2u);
  EXPECT_NEAR(degrees(ways->at(0), kA), 90, 1e-12);
  EXPECT_NEAR(degrees(ways->at(0), kC), 0, 1e-12);
  EXPECT_NEAR(degrees(ways->at(1), kA), -90, 1e-12);
  EXPECT_NEAR(std::fabs(degrees(ways->at(1), kC)), 180, 1e-12);
}

TEST(Inverse, AtThePoleTheJointBelowStaysWhereItIs) {
  const auto ways = rotary_solutions(trunnion(), Vector3d::UnitZ(), axes(0, 0, 0, 5, 0, 33));
  ASSERT_TRUE(ways);
  EXPECT_EQ(degrees(ways->front(), kA), 0);
  EXPECT_EQ(degrees(ways->front(), kC), 33);
}

// A micro-degree beside the pole C counts again.
TEST(Inverse, BesideThePoleEveryAngleCounts) {
  const double tilt = 1e-6 * kRadiansPerDegree;
  const auto ways = rotary_solutions(trunnion(), {std::sin(tilt), 0, std::cos(tilt)}, axes(0, 0, 0));
  ASSERT_TRUE(ways);
  for (const AxisVector& way : *ways) {
    EXPECT_NEAR(std::fabs(degrees(way, kC)), 90, 1e-4);
    EXPECT_NEAR(std::fabs(degrees(way, kA)), 1e-6, 1e-13);
  }
}

TEST(Inverse, WindsOnAsFarAsTheTravelLets) {
  const Vector3d along_x = Vector3d::UnitX();  // B = 90° and C = 0, or B = −90° and C = 180°
  AxisVector near = axes(0, 0, 0, 0, 80, 700);
  const auto free = rotary_solutions(head_and_table(), along_x, near);
  ASSERT_TRUE(free);
  EXPECT_NEAR(degrees(free->front(), kC), 720, 1e-9);
  RotaryTravel travel = RotaryTravel::unbounded();
  travel.low[kC] = -360 * kRadiansPerDegree;
  travel.high[kC] = 360 * kRadiansPerDegree;
  const auto held = rotary_solutions(head_and_table(), along_x, near, travel);
  ASSERT_TRUE(held);
  for (const AxisVector& way : *held) EXPECT_LE(degrees(way, kC), 360 + 1e-9);
  travel.low[kB] = travel.high[kB] = 0;
  const auto none = rotary_solutions(head_and_table(), along_x, near, travel);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, "rotary-travel");
  EXPECT_EQ(none.error().kind, ErrorKind::infeasible);
}

// With 45° of inclination the tool comes as far as horizontal, not below: 30° are missing.
TEST(Inverse, TellsHowFarADirectionIsOutOfReach) {
  const double below = 120 * kRadiansPerDegree;
  const auto ways = rotary_solutions(nutating_head(), {std::sin(below), 0, std::cos(below)}, axes(0, 0, 0));
  ASSERT_FALSE(ways);
  EXPECT_EQ(ways.error().code, "tool-direction-unreachable");
  EXPECT_NEAR(ways.error().attainable.value_or(0) / kRadiansPerDegree, 30, 1e-9);
  EXPECT_TRUE(rotary_solutions(nutating_head(), Vector3d::UnitX(), axes(0, 0, 0))) << "just";
}

TEST(Inverse, OfFewerJointsReachesWhatTheyReach) {
  Chain chain = trunnion();
  chain.joints.pop_back();
  ASSERT_TRUE(rotary_solutions(chain, Vector3d::UnitY(), axes(0, 0, 0)));
  EXPECT_FALSE(rotary_solutions(chain, Vector3d::UnitX(), axes(0, 0, 0)));
  EXPECT_TRUE(rotary_solutions({}, Vector3d::UnitZ(), axes(0, 0, 0)));
  EXPECT_FALSE(rotary_solutions({}, Vector3d::UnitY(), axes(0, 0, 0)));
}

// Heads and tables of any direction: every way points the tool as asked, and one of them is where it came from.
TEST(RandomChains, EveryWayOfTheInversePointsTheToolAsAsked) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&] { return Vector3d(unit(random), unit(random), unit(random)); };
  for (int k = 0; k < 10000; ++k) {
    Chain chain{{}, 80};
    for (const std::size_t axis : {kB, kC}) {
      chain.joints.push_back(
          {axis, random() % 2 ? ChainSide::table : ChainSide::head, vector().normalized(), 100 * vector()});
    }
    const AxisVector from =
        axes(300 * unit(random), 300 * unit(random), 300 * unit(random), 0, 180 * unit(random), 180 * unit(random));
    const ToolPose pose = forward(chain, from);
    const auto ways = rotary_solutions(chain, pose.tool, from);
    ASSERT_TRUE(ways) << "chain " << k;
    double nearest = 1e9;
    for (const AxisVector& way : *ways) {
      const ToolPose again = forward(chain, axes_at(chain, pose.tip, way));
      ASSERT_LT((again.tip - pose.tip).norm(), 1e-10) << "chain " << k;
      ASSERT_LT((again.tool - pose.tool).norm(), 1e-7) << "chain " << k;  // where both cones only touch: √ of rounding
      nearest = std::min(nearest, (axes_at(chain, pose.tip, way) - from).cwiseAbs().maxCoeff());
    }
    ASSERT_LT(nearest, 1e-4) << "chain " << k;
  }
}

}  // namespace
}  // namespace toolpace
