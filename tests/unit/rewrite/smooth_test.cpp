#include <gtest/gtest.h>

#include <cmath>

#include "curves.h"
#include "toolpace/rewrite/fit_smooth.h"
#include "toolpace/rewrite/tangents.h"

namespace toolpace::detail::rewrite {
namespace {

using test::circle;
using test::curve_of;

/// A clothoid: its curvature grows with the way, from 0 to 0.2/mm over 10 mm, so that no arc follows it far.
Curve clothoid() {
  std::vector<Eigen::Vector3d> points{{0, 0, 0}};
  constexpr int kFine = 100;
  double x = 0, y = 0;
  for (int k = 0; k < 200 * kFine; ++k) {
    const double s = (k + 0.5) * 10.0 / (200 * kFine), angle = 0.01 * s * s;
    x += std::cos(angle) * 10.0 / (200 * kFine);
    y += std::sin(angle) * 10.0 / (200 * kFine);
    if ((k + 1) % kFine == 0) points.push_back({x, y, 0});
  }
  return curve_of(points);
}

TEST(TheTangentOfACurve, IsThatOfTheParabolaThroughItsPoints) {
  const Curve curve = circle(10, 2, 100);
  const Tangents tangents(curve, std::vector<double>(101, 1.0));
  // In the middle, at an angle of 1 rad, symmetry leaves errors of the fourth order alone.
  const Eigen::Vector3d at = tangents.arriving(50);
  EXPECT_NEAR(at.x(), -std::sin(1.0), 1e-4);
  EXPECT_NEAR(at.y(), std::cos(1.0), 1e-4);
  EXPECT_EQ(at, tangents.leaving(50));
  // At the end the third order is missed: (2 mm/10 mm)³ at most.
  EXPECT_NEAR(std::atan2(tangents.leaving(0).y(), tangents.leaving(0).x()), std::acos(-1.0) / 2, 0.008);
}

TEST(ABiarc, LeavesAndArrivesAsItIsTold) {
  const Curve curve = clothoid();
  const Eigen::Vector3d out(1, 0, 0), in(std::cos(1.0), std::sin(1.0), 0);
  const auto biarc = BiarcFitter(curve, {}, {}, 0.3).fit(17, 0, 200, out, in);
  ASSERT_TRUE(biarc);
  // Radii stand at right angles to both directions, and meet in one line at the joint.
  EXPECT_NEAR(biarc->first.i, 0, 1e-3);
  const Eigen::Vector2d joint = biarc->joint.head<2>(), end = curve.point.back().head<2>();
  const Eigen::Vector2d one = Eigen::Vector2d(biarc->first.i, biarc->first.j) - joint;
  const Eigen::Vector2d two(biarc->second.i, biarc->second.j), last = joint + two - end;
  EXPECT_NEAR(one.normalized().dot(Eigen::Vector2d(-two.y(), two.x()).normalized()), 0, 1e-3);
  EXPECT_NEAR(last.normalized().dot(in.head<2>()), 0, 1e-3);
  EXPECT_FALSE(BiarcFitter(curve, {}, {}, 0.02).fit(17, 0, 200, out, in));
}

TEST(ACurve, IsFollowedByBlocksWithoutCorners) {
  const Curve curve = clothoid();
  const FitRules rules;
  const auto plain = fit_run(curve, rules, 17);
  const auto smooth = fit_smooth(curve, rules, 17, plain);
  std::size_t biarcs = 0;
  for (const Span& span : smooth) biarcs += span.kind == Span::Kind::biarc ? 1 : 0;
  EXPECT_GT(biarcs, 0u);
  EXPECT_LT(smooth.size(), 20u);
  EXPECT_EQ(smooth.back().last, 200u);
}

TEST(ACircle, IsOneArcAnyway) {
  const Curve curve = circle(10, 2, 100);
  const auto smooth = fit_smooth(curve, {}, 17, fit_run(curve, {}, 17));
  ASSERT_EQ(smooth.size(), 1u);
  EXPECT_EQ(smooth[0].kind, Span::Kind::arc);
}

}  // namespace
}  // namespace toolpace::detail::rewrite
