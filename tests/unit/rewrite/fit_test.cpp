#include <gtest/gtest.h>

#include <cmath>

#include "curves.h"
#include "toolpace/rewrite/fit_line.h"
#include "toolpace/rewrite/fit_run.h"

namespace toolpace::detail::rewrite {
namespace {

using test::circle;
using test::curve_of;
using test::kPi;

TEST(ALine, FitsWhatIsWithinTheToleranceOfIt) {
  const Curve curve = curve_of({{0, 0, 0}, {1, 0.01, 0}, {2, 0, -0.01}, {3, 0, 0}});
  EXPECT_TRUE(fits_line(curve, 0, 3, 0.0101));
  EXPECT_FALSE(fits_line(curve, 0, 3, 0.0099));
}

TEST(ALine, DoesNotGoBackAndForth) {
  // A stroke back by 0.5 keeps to the line, but no walk along it stays within less than half of that.
  const Curve curve = curve_of({{0, 0, 0}, {2, 0, 0}, {1.5, 0, 0}, {3, 0, 0}});
  EXPECT_FALSE(fits_line(curve, 0, 3, 0.24));
  EXPECT_TRUE(fits_line(curve, 0, 3, 0.51));
}

TEST(AnArc, IsFoundThroughChordsOfACircle) {
  const Curve curve = circle(10, 2, 100);
  ArcFitter fitter(curve, {}, 0.01);
  const auto arc = fitter.fit(17, 0, 100);
  ASSERT_TRUE(arc);
  // Chords of 0.2 mm lie inside by 0.2²/(8·10) = 0.0005 mm: a centre that evens that out is off by as little.
  EXPECT_NEAR(arc->i, -10, 0.002);
  EXPECT_NEAR(arc->j, 0, 0.002);
  EXPECT_FALSE(arc->clockwise);
  EXPECT_EQ(arc->turns, 1);
  EXPECT_FALSE(fitter.fit(18, 0, 100));
  EXPECT_FALSE(fitter.fit(19, 0, 100));
}

TEST(AnArc, IsNoPolygon) {
  // A hexagon lies within 0.14·r of its circle; its sides are no chords of a curve, whatever the tolerance.
  const Curve curve = circle(0.05, 2 * kPi, 6);
  EXPECT_FALSE(ArcFitter(curve, {}, 0.01).fit(17, 0, 5));
}

TEST(AHelix, IsOneBlockWhereItMayTurnOn) {
  const Curve curve = circle(10, 6 * kPi, 600, 1.0);  // three turns, 1 mm each
  ArcRules rules;
  EXPECT_FALSE(ArcFitter(curve, rules, 0.01).fit(17, 0, 600));
  rules.may_turn_on = true;
  Curve exact = curve;
  for (const std::size_t k : {200u, 400u, 600u}) exact.point[k].head<2>() = exact.point[0].head<2>();
  const auto helix = ArcFitter(exact, rules, 0.01).fit(17, 0, 600);
  ASSERT_TRUE(helix);
  EXPECT_EQ(helix->turns, 3);
  rules.may_turn_on = false;
  const auto turn = ArcFitter(exact, rules, 0.01).fit(17, 0, 200);
  ASSERT_TRUE(turn);
  EXPECT_EQ(turn->turns, 1);
}

TEST(AHelix, RisesEvenly) {
  Curve curve = circle(10, 2, 100, 1.0);
  EXPECT_TRUE(ArcFitter(curve, {}, 0.01).fit(17, 0, 100));
  for (std::size_t k = 40; k < 60; ++k) curve.point[k].z() += 0.011;
  EXPECT_FALSE(ArcFitter(curve, {}, 0.01).fit(17, 0, 100));
}

TEST(ARun, EndsItsBlocksAtBarriers) {
  std::vector<Eigen::Vector3d> points;
  for (int k = 0; k <= 10; ++k) points.push_back({0.1 * k, 0, 0});
  Curve curve = curve_of(points);
  EXPECT_EQ(fit_run(curve, {}, 17).size(), 1u);
  curve.barrier[4] = 1;
  const auto spans = fit_run(curve, {}, 17);
  ASSERT_EQ(spans.size(), 2u);
  EXPECT_EQ(spans[0].last, 4u);
  EXPECT_EQ(spans[1].first, 4u);
}

TEST(ARunOfNoise, LosesNothingWhereItWouldGainLittle) {
  // Two rows within the whole tolerance, but not well within it.
  const Curve curve = curve_of({{0, 0, 0}, {1, 0.009, 0}, {2, 0, 0}});
  const auto spans = fit_run(curve, {}, 17);
  ASSERT_EQ(spans.size(), 2u);
  EXPECT_EQ(spans[0].kind, Span::Kind::kept);
}

}  // namespace
}  // namespace toolpace::detail::rewrite
