#include "toolpace/limits/curve_budget.h"

#include <gtest/gtest.h>

#include <algorithm>
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

/// Largest derivatives by dense sampling, against the bound: never above it, and the bound not far above them. Axes that
/// have little of the whole are judged by a part of it.
void expect_tight(const Path& path, std::size_t i, const char* what) {
  constexpr int kSamples = 1500;
  const CurveBounds bound = curve_bounds(path, i);
  CurveBounds most{AxisVector::Zero(), AxisVector::Zero(), AxisVector::Zero()};
  for (int k = 0; k <= kSamples; ++k) {
    const ParameterDerivatives d = derivatives_at_share(path, i, static_cast<double>(k) / kSamples);
    most.first = most.first.cwiseMax(d.first.cwiseAbs());
    most.second = most.second.cwiseMax(d.second.cwiseAbs());
    most.third = most.third.cwiseMax(d.third.cwiseAbs());
  }
  const double length = path.length[i];
  const auto compare = [&](const AxisVector& b, const AxisVector& m, double rounding, int order) {
    for (Eigen::Index axis = 0; axis < m.size(); ++axis) {
      const double whole = (axis < 3 ? m.head<3>() : m.tail<3>()).maxCoeff();
      EXPECT_LE(m[axis], b[axis] * (1 + 1e-9) + rounding) << what << ", derivative " << order << ", axis " << axis;
      EXPECT_LE(b[axis], 1.15 * m[axis] + 0.02 * whole + rounding)
          << what << ", derivative " << order << ", axis " << axis;
    }
  };
  compare(bound.first, most.first, 1e-9, 1);
  compare(bound.second, most.second, 1e-8 / length, 2);
  compare(bound.third, most.third, 1e-8 / (length * length), 3);
}

TEST(CurveBounds, ContainRandomSplinesTightly) {
  std::mt19937_64 random(20260202);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::size_t pieces = 0;
  for (int n = 0; n < 60; ++n) {
    const int degree = 2 + n % 4;
    const int spans = 1 + n % 5, count = degree + spans;
    SplineDetail spline;
    spline.degree = degree;
    for (int k = 0; k < count; ++k) {
      spline.points.emplace_back(10.0 * k + 6 * unit(random), 20 * unit(random), n % 3 == 0 ? 5 * unit(random) : 0.0);
      if (n % 2 == 0) spline.weights.push_back(std::exp(unit(random)));
    }
    for (int k = 0; k <= count + degree; ++k) {
      spline.knots.push_back(std::clamp(k - degree, 0, spans));
    }
    Moves moves = one_arc(1, 1, 0, 1000);
    moves.start.head<3>() = spline.points.front();
    moves.end[0].setZero();
    moves.end[0].head<3>() = spline.points.back();
    if (n % 5 == 0) moves.end[0][3] = unit(random);
    moves.kind = {MoveKind::spline};
    moves.arcs.clear();
    moves.splines = {spline};
    const auto path = build_path(moves, 0);
    ASSERT_TRUE(path);
    for (std::size_t i = 0; i < path->size(); i += 3) expect_tight(*path, i, "spline");
    pieces += path->size();
  }
  EXPECT_GT(pieces, 500u);
}

TEST(CurveBounds, ContainBlendsOfEveryAngleTightly) {
  std::mt19937_64 random(20260303);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int n = 0; n < 300; ++n) {
    const double angle = 3.05 * unit(random), turned = 3 * unit(random);  // corner, and how it lies
    Path path;
    AxisVector before = AxisVector::Zero(), after = AxisVector::Zero();
    before.head<3>() << std::cos(turned), std::sin(turned), 0.0;
    after.head<3>() << std::cos(turned + angle), std::sin(turned + angle), 0.0;
    if (n % 3 == 0) after[3] = unit(random);
    path.kind = {SegmentKind::blend};
    path.detail = {0};
    path.corner_blends = {{AxisVector::Zero(), before, after}};
    path.length = {blend_length(path.corner_blends[0])};
    path.node = {-before, after};
    expect_tight(path, 0, "corner blend");
    const BlendEnd begin{-before, before, AxisVector::Zero()};
    AxisVector bend = AxisVector::Zero();
    bend.head<3>() << -after[1], after[0], 0.0;
    const BlendEnd end{after, after, 0.5 * unit(random) * bend};
    if (std::abs(angle) > 1.8) continue;  // sharper corners get no blend
    path.detail = {Path::kCurveBlend};
    path.curve_blends = {make_curve_blend(begin, end, 1.6)};
    path.length = {blend_length(path.curve_blends[0])};
    expect_tight(path, 0, "curve blend");
  }
}

}  // namespace
}  // namespace toolpace
