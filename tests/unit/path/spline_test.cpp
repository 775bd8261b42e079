#include "toolpace/path/spline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "toolpace/path/build_path.h"
#include "toolpace/path/piece_walker.h"

namespace toolpace {
namespace {

AxisVector at(double x, double y) {
  AxisVector p = AxisVector::Zero();
  p[0] = x;
  p[1] = y;
  return p;
}

/// Quarter circle of radius 10 as a rational quadratic: weights 1, cos 45°, 1.
SplineDetail quarter_circle() {
  return {2, {{10, 0, 0}, {10, 10, 0}, {0, 10, 0}}, {1, std::sqrt(0.5), 1}, {0, 0, 0, 1, 1, 1}};
}

Moves one_spline(const SplineDetail& detail) {
  Moves moves;
  moves.start.head<3>() = detail.points.front();
  moves.kind = {MoveKind::spline};
  moves.line = {1};
  moves.file = {0};
  moves.mode = {0};
  moves.detail = {0};
  AxisVector end = AxisVector::Zero();
  end.head<3>() = detail.points.back();
  moves.end = {end};
  moves.feed = {10};
  moves.splines = {detail};
  return moves;
}

TEST(Spline, RationalQuarterCircleIsACircle) {
  const SplineCurve curve = make_spline(at(10, 0), at(0, 10), quarter_circle());
  for (const double u : {0.0, 0.2, 0.5, 0.8, 1.0}) {
    EXPECT_NEAR(spline_point(curve, u).head<2>().norm(), 10, 1e-13);
  }
}

TEST(Spline, PiecesAddUpToTheArcLength) {
  const SplineCurve curve = make_spline(at(10, 0), at(0, 10), quarter_circle());
  double length = 0;
  for (const SplinePiece& piece : cut_spline(curve, 0)) length += piece_length(curve, piece.begin, piece.end);
  EXPECT_NEAR(length, 5 * std::numbers::pi, 1e-10);
}

TEST(Spline, FrameOfTheQuarterCircleHasItsCurvature) {
  const auto path = build_path(one_spline(quarter_circle()), 0.0);
  ASSERT_TRUE(path);
  for (std::size_t i = 0; i < path->size(); ++i) {
    const Frame f = frame_at(*path, i, path->length[i] * 0.37);
    EXPECT_NEAR(f.first.norm(), 1, 1e-13);
    EXPECT_NEAR(f.second.norm(), 0.1, 1e-11);
    EXPECT_NEAR(f.third.norm(), 0.01, 1e-9);
    EXPECT_NEAR(f.point.head<2>().norm(), 10, 1e-12);
  }
}

TEST(Spline, DerivativesOfAQuinticAgreeWithDifferences) {
  const SplineDetail detail{5,
                            {{0, 0, 0}, {3, 9, 1}, {8, -4, 2}, {12, 7, 0}, {15, 1, 3}, {20, 0, 0}, {22, 5, 1}},
                            {1, 2, 1, 0.5, 1, 1, 1},
                            {0, 0, 0, 0, 0, 0, 0.4, 1, 1, 1, 1, 1, 1}};
  const SplineCurve curve = make_spline(at(0, 0), at(22, 5), detail);
  const double e = 1e-5;
  for (const double u : {0.1, 0.39, 0.41, 0.9}) {
    const ParameterDerivatives d = spline_derivatives(curve, u);
    const ParameterDerivatives a = spline_derivatives(curve, u - e), b = spline_derivatives(curve, u + e);
    EXPECT_LT(((spline_point(curve, u + e) - spline_point(curve, u - e)) / (2 * e) - d.first).norm(), 1e-5);
    EXPECT_LT(((b.first - a.first) / (2 * e) - d.second).norm(), 1e-4);
    EXPECT_LT(((b.second - a.second) / (2 * e) - d.third).norm(), 1e-2);
  }
}

TEST(Spline, APieceEndsWithTheCurvatureOfItsOwnSideOfTheKnot) {
  // A curve of degree 2 from knot to knot: its second derivative jumps there.
  const SplineCurve curve = make_spline(
      at(0, 0), at(20, 0), {2, {{0, 0, 0}, {5, 9, 0}, {12, -4, 0}, {20, 0, 0}}, {1, 2, 1, 1}, {0, 0, 0, 1, 2, 2, 2}});
  const SplinePiece left{0, 0.5, 1.0}, right{0, 1.0, 1.5};
  const ParameterDerivatives before = spline_derivatives(curve, left, 1.0);
  const ParameterDerivatives after = spline_derivatives(curve, right, 1.0);
  EXPECT_LT((spline_derivatives(curve, 1.0 - 1e-9).second - before.second).norm(), 1e-5);
  EXPECT_LT((spline_derivatives(curve, 1.0 + 1e-9).second - after.second).norm(), 1e-5);
  EXPECT_LT((after.first - before.first).norm(), 1e-12);
  EXPECT_GT((after.second - before.second).norm(), 1.0);
}

TEST(Spline, ParameterInvertsLength) {
  const SplineCurve curve = make_spline(at(10, 0), at(0, 10), quarter_circle());
  const SplinePiece piece = cut_spline(curve, 0).front();
  const double length = piece_length(curve, piece.begin, piece.end);
  for (const double share : {0.0, 0.25, 0.99, 1.0}) {
    const double u = parameter_at(curve, piece, length, share * length);
    EXPECT_NEAR(piece_length(curve, piece.begin, u), share * length, 1e-12 * length);
  }
}

TEST(Spline, ACurveThatStartsWithoutParameterSpeedHasADirection) {
  // G5 with I0 J0: the first two control points coincide.
  const SplineDetail slow{3, {{0, 0, 0}, {0, 0, 0}, {10, 5, 0}, {20, 0, 0}}, {}, {0, 0, 0, 0, 1, 1, 1, 1}};
  const auto path = build_path(one_spline(slow), 0.0);
  ASSERT_TRUE(path);
  EXPECT_NEAR(start_direction(*path, 0).norm(), 1, 1e-12);
  EXPECT_TRUE(end_direction(*path, path->size() - 1).allFinite());
}

TEST(Spline, CurveWithACuspIsCutIntoABoundedNumberOfPieces) {
  // Control points that fold back make a cusp, where curvature is unbounded.
  const SplineDetail cusp{3, {{0, 0, 0}, {10, 10, 0}, {0, 10, 0}, {10, 0, 0}}, {}, {0, 0, 0, 0, 1, 1, 1, 1}};
  const auto path = build_path(one_spline(cusp), 0.0);
  ASSERT_TRUE(path);
  EXPECT_LE(path->size(), 4096u);
  for (const double length : path->length) EXPECT_GT(length, 0);
}

// Degrees 2 to 7, with and without weights, evenly spaced knots and others, a rotary axis.
TEST(Spline, AWalkerFindsThePointsThatTheCurveHasAtTheirLength) {
  std::mt19937_64 random(20260404);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::size_t pieces = 0, exact = 0;
  for (int n = 0; n < 40; ++n) {
    const int degree = 2 + n % 6, spans = 1 + n % 4, count = degree + spans;
    SplineDetail detail;
    detail.degree = degree;
    for (int k = 0; k < count; ++k) {
      detail.points.emplace_back(5.0 * k + 2 * unit(random), 8 * unit(random), n % 3 == 0 ? 5 * unit(random) : 0.0);
      if (n % 2 == 0) detail.weights.push_back(std::exp(unit(random)));
    }
    for (int k = 0; k <= count + degree; ++k) detail.knots.push_back(std::clamp(k - degree, 0, spans) * (1 + n % 3));
    AxisVector end = at(detail.points.back()[0], detail.points.back()[1]);
    end[3] = n % 5 == 0 ? 1.5 : 0.0;
    const SplineCurve curve = make_spline(at(0, 0), end, detail);
    for (const SplinePiece& piece : cut_spline(curve, 0)) {
      ++pieces;
      const double length = piece_length(curve, piece.begin, piece.end);
      const PieceWalker walker(curve, piece, length);
      if (!walker.is_exact()) continue;
      ++exact;
      for (const double share : {1e-6, 0.02, 0.37, 0.5, 0.81, 1.0}) {
        const AxisVector there = spline_point(curve, parameter_at(curve, piece, length, share * length));
        EXPECT_LT((walker.point_at(share * length) - there).norm(), 1e-12 * (length + there.norm()))
            << "curve " << n << ", " << share;
      }
    }
  }
  EXPECT_GT(exact, pieces * 9 / 10);
}

TEST(Spline, AWalkerTellsWhereTheLengthIsNoPolynomial) {
  const SplineDetail cusp{3, {{0, 0, 0}, {10, 10, 0}, {0, 10, 0}, {10, 0, 0}}, {}, {0, 0, 0, 0, 1, 1, 1, 1}};
  const SplineCurve curve = make_spline(at(0, 0), at(10, 0), cusp);
  const double length = piece_length(curve, 0, 1);
  EXPECT_FALSE(PieceWalker(curve, {0, 0, 1}, length).is_exact());
}

}  // namespace
}  // namespace toolpace
