#include "toolpace/limits/curve_budget.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "toolpace/path/build_path.h"

namespace toolpace {
namespace {

Moves one_arc(double radius, double sweep, double rise, double feed) {
  Moves moves;
  moves.start[0] = radius;
  AxisVector end = AxisVector::Zero();
  end[0] = radius * std::cos(sweep);
  end[1] = radius * std::sin(sweep);
  end[2] = rise;
  moves.kind = {MoveKind::arc};
  moves.line = {1};
  moves.file = {0};
  moves.mode = {0};
  moves.detail = {0};
  moves.end = {end};
  moves.feed = {feed};
  moves.arcs = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), sweep}};
  return moves;
}

std::array<AxisLimits, kAxisCount> axes_with(double speed, double acceleration, double jerk) {
  std::array<AxisLimits, kAxisCount> axes;
  for (std::size_t k = 0; k < 3; ++k) {
    axes[k].speed = speed;
    axes[k].acceleration = acceleration;
    axes[k].jerk = jerk;
  }
  return axes;
}

TEST(CurveBudget, LineLeavesWhatItsDirectionAllows) {
  CurveBounds bounds{AxisVector::Zero(), AxisVector::Zero(), AxisVector::Zero()};
  bounds.first << 0.6, 0.8, 0, 0, 0, 0;
  const CurveBudget budget = curve_budget(bounds, axes_with(100, 2000, 50000), 1000);
  EXPECT_DOUBLE_EQ(budget.speed, 125);
  EXPECT_DOUBLE_EQ(budget.acceleration, 2500);
  EXPECT_DOUBLE_EQ(budget.jerk, 62500);
  EXPECT_FALSE(budget.is_curvature);
}

TEST(CurveBudget, SmallCircleIsCappedByItsCurvature) {
  const auto path = build_path(one_arc(0.5, std::numbers::pi, 0, 1000), 0);
  ASSERT_TRUE(path);
  const CurveBudget budget = curve_budget(curve_bounds(*path, 0), axes_with(1000, 2000, kUnlimited), 1000);
  EXPECT_TRUE(budget.is_curvature);
  EXPECT_LE(budget.speed * budget.speed / 0.5, 2000);
  EXPECT_GT(budget.acceleration, 0);
}

// Whatever v ≤ speed, |a| ≤ acceleration, |j| ≤ jerk: axis acceleration u·a + k·v² and axis jerk u·j + 3k·v·a + t·v³.
TEST(CurveBudget, AxesKeepTheirLimitsOnRandomArcsAnywhere) {
  std::mt19937_64 random(20260101);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int n = 0; n < 3000; ++n) {
    const double radius = std::pow(10, 2 * unit(random)), sweep = 0.01 + 3.2 * (1 + unit(random));
    const auto path = build_path(one_arc(radius, sweep, 3 * radius * unit(random), 1000), 0);
    ASSERT_TRUE(path);
    const auto axes = axes_with(100 * (2 + unit(random)), 1000 * (2 + unit(random)), 30000 * (2 + unit(random)));
    const CurveBudget b = curve_budget(curve_bounds(*path, 0), axes, 100);
    ASSERT_GT(b.speed, 0);
    ASSERT_GT(b.acceleration, 0);
    ASSERT_GT(b.jerk, 0);
    for (int m = 0; m < 30; ++m) {
      const Frame f = frame_at(*path, 0, path->length[0] * (1 + unit(random)) / 2);
      const double v = b.speed * (1 + unit(random)) / 2, a = b.acceleration * unit(random), j = b.jerk * unit(random);
      for (Eigen::Index k = 0; k < 3; ++k) {
        const AxisLimits& axis = axes[static_cast<std::size_t>(k)];
        EXPECT_LE(std::abs(f.first[k] * v), axis.speed * (1 + 1e-9));
        EXPECT_LE(std::abs(f.first[k] * a + f.second[k] * v * v), axis.acceleration * (1 + 1e-9)) << "case " << n;
        EXPECT_LE(std::abs(f.first[k] * j + 3 * f.second[k] * v * a + f.third[k] * v * v * v), axis.jerk * (1 + 1e-9));
      }
    }
  }
}

}  // namespace
}  // namespace toolpace
