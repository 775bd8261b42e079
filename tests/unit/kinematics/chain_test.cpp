#include "toolpace/kinematics/chain.h"

#include <gtest/gtest.h>

#include <random>

#include "chains.h"

namespace toolpace {
namespace {

using Eigen::Vector3d;
using namespace testing;

void expect_near(const Vector3d& a, const Vector3d& b, double within) {
  EXPECT_LT((a - b).norm(), within) << a.transpose() << " against " << b.transpose();
}

TEST(Chain, WithoutJointsLeavesTheAxesAsTheyAre) {
  const ToolPose pose = forward({}, axes(1, 2, 3, 40, 50, 60));
  EXPECT_EQ(pose.tip, Vector3d(1, 2, 3));
  EXPECT_EQ(pose.tool, Vector3d::UnitZ());
}

TEST(Chain, AtAnglesOfZeroTheTipIsWhereTheAxesAre) {
  for (const Chain& chain : {trunnion(), head_and_table(), nutating_head()}) {
    expect_near(forward(chain, axes(1, 2, 3)).tip, {1, 2, 3}, 1e-13);
    EXPECT_EQ(forward(chain, axes(1, 2, 3)).tool, Vector3d::UnitZ());
  }
}

// A = 90° about X through (0, 0, −50) takes the workpiece's zero to (0, −50, −50), and its Y towards the spindle.
TEST(Chain, ATableTakesTheWorkpieceWithIt) {
  const AxisVector there = axes_at(trunnion(), Vector3d::Zero(), axes(0, 0, 0, 90));
  expect_near(there.head<3>(), {0, -50, -50}, 1e-13);
  const ToolPose pose = forward(trunnion(), there);
  expect_near(pose.tip, Vector3d::Zero(), 1e-13);
  expect_near(pose.tool, Vector3d::UnitY(), 1e-15);
}

// B = 90° about Y through (0, 0, 30) above the nose: the tip, 130 mm below it, swings to −X.
TEST(Chain, AHeadTakesTheToolWithIt) {
  const ToolPose pose = forward(head_and_table(), axes(0, 0, 0, 0, 90));
  expect_near(pose.tip, {-130, 0, 130}, 1e-13);
  expect_near(pose.tool, Vector3d::UnitX(), 1e-15);
}

// Half a turn about (0, 1, 1)/√2 takes Z to Y.
TEST(Chain, ANutatingHeadLaysTheToolDown) {
  expect_near(forward(nutating_head(), axes(0, 0, 0, 0, 180)).tool, Vector3d::UnitY(), 1e-15);
  expect_near(forward(nutating_head(), axes(0, 0, 0, 0, 180, 90)).tool, -Vector3d::UnitX(), 1e-15);
}

// A point at radius r of a table that turns at ω: the axes go round with it, v = rω, a = rω², j = rω³.
TEST(Chain, DerivativesOfAPointOnATurningTableAreThoseOfACircle) {
  const Chain chain{{{kC, ChainSide::table, Vector3d::UnitZ(), {0, 0, 0}}}};
  const double r = 40, w = 3, angle = 0.7;
  Derivatives<AxisVector> rotary = {axes(0, 0, 0), axes(0, 0, 0), axes(0, 0, 0), axes(0, 0, 0)};
  rotary[0][5] = angle;
  rotary[1][5] = w;
  const auto d = axes_along(chain, {Vector3d(r, 0, 0), Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()}, rotary);
  const Vector3d out(std::cos(angle), std::sin(angle), 0), along(-std::sin(angle), std::cos(angle), 0);
  expect_near(d[0].head<3>(), r * out, 1e-13);
  expect_near(d[1].head<3>(), r * w * along, 1e-12);
  expect_near(d[2].head<3>(), -r * w * w * out, 1e-12);
  expect_near(d[3].head<3>(), -r * w * w * w * along, 1e-11);
  EXPECT_EQ(d[1][5], w);
}

Chain random_chain(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  Chain chain{{}, 50 * (1 + unit(random))};
  const std::size_t count = random() % 3;
  for (std::size_t k = 0; k < count; ++k) {
    const Vector3d direction(unit(random), unit(random), unit(random) + 0.1);
    chain.joints.push_back({kA + k, random() % 2 ? ChainSide::table : ChainSide::head, direction.normalized(),
                            100 * Vector3d(unit(random), unit(random), unit(random))});
  }
  return chain;
}

TEST(RandomChains, AreTheirOwnInverseWithAllDerivatives) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int k = 0; k < 2000; ++k) {
    const Chain chain = random_chain(random);
    Derivatives<Vector3d> tip;
    Derivatives<AxisVector> rotary;
    for (std::size_t order = 0; order < tip.size(); ++order) {
      tip[order] = 100 * Vector3d(unit(random), unit(random), unit(random));
      rotary[order] = 3 * AxisVector::NullaryExpr([&] { return unit(random); });
    }
    const auto back = tip_along(chain, axes_along(chain, tip, rotary));
    for (std::size_t order = 0; order < tip.size(); ++order) {
      ASSERT_LT((back[order] - tip[order]).norm(), 1e-10) << "chain " << k << ", derivative " << order;
    }
    const ToolPose pose = forward(chain, axes_at(chain, tip[0], rotary[0]));
    ASSERT_LT((pose.tip - tip[0]).norm(), 1e-11) << "chain " << k;
    ASSERT_NEAR(pose.tool.norm(), 1, 1e-14);
  }
}

// Each derivative is the difference of the one before it: by Taylor's rest an error of h²/6 of the third after it.
TEST(RandomChains, DerivativesAreThoseOfDifferences) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int k = 0; k < 200; ++k) {
    const Chain chain = random_chain(random);
    std::array<std::array<double, 4>, 6> c;  // cubics of the tip and the three angles
    for (auto& cubic : c) {
      for (double& value : cubic) value = unit(random);
    }
    const auto at = [&](double t) {
      Derivatives<Vector3d> tip;
      Derivatives<AxisVector> rotary;
      for (std::size_t i = 0; i < c.size(); ++i) {
        const auto& [a, b, d, e] = c[i];
        const std::array<double, 4> value = {a + t * (b + t * (d + t * e)), b + t * (2 * d + 3 * t * e),
                                             2 * d + 6 * t * e, 6 * e};
        for (std::size_t order = 0; order < 4; ++order) {
          if (i < 3) tip[order][static_cast<Eigen::Index>(i)] = 100 * value[order];
          rotary[order][static_cast<Eigen::Index>(i)] = 0;
          if (i >= 3) rotary[order][static_cast<Eigen::Index>(i)] = value[order];
        }
      }
      return axes_along(chain, tip, rotary);
    };
    const double h = 1e-4;
    const auto before = at(0.3 - h), here = at(0.3), after = at(0.3 + h);
    for (std::size_t order = 1; order < 4; ++order) {
      const AxisVector difference = (after[order - 1] - before[order - 1]) / (2 * h);
      ASSERT_LT((difference - here[order]).norm(), 1e-6 * (1 + here[order].norm()) + 1e-4)
          << "chain " << k << ", " << order;
    }
  }
}

}  // namespace
}  // namespace toolpace
