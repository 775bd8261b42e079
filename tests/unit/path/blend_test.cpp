#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "frechet.h"
#include "toolpace/path/blend_halves.h"
#include "toolpace/path/blend_path.h"
#include "toolpace/path/build_path.h"

namespace toolpace {
namespace {

AxisVector at(double x, double y, double z = 0) {
  AxisVector p = AxisVector::Zero();
  p.head<3>() << x, y, z;
  return p;
}

void add_line(Moves& moves, const AxisVector& end, double feed = 100, std::uint16_t mode = 0) {
  moves.kind.push_back(MoveKind::feed);
  moves.line.push_back(static_cast<std::uint32_t>(moves.kind.size()));
  moves.file.push_back(0);
  moves.mode.push_back(mode);
  moves.detail.push_back(kNoDetail);
  moves.end.push_back(end);
  moves.feed.push_back(feed);
}

void add_arc(Moves& moves, const AxisVector& end, const ArcDetail& arc) {
  add_line(moves, end);
  moves.kind.back() = MoveKind::arc;
  moves.detail.back() = static_cast<std::uint32_t>(moves.arcs.size());
  moves.arcs.push_back(arc);
}

Path built(const Moves& moves) { return *build_path(moves, 0.0); }

BlendedPath blended(const Moves& moves, double tolerance = 0.01, bool everywhere = true) {
  return *blend_path(built(moves), moves, {tolerance, everywhere});
}

/// Points along a path, `count` a segment.
test::Points sampled(const Path& path, int count) {
  test::Points points = {path.node.front()};
  for (std::size_t i = 0; i < path.size(); ++i) {
    for (int k = 1; k <= count; ++k) points.push_back(point_at(path, i, path.length[i] * k / count));
  }
  for (auto& p : points) p.tail(3) /= kRadiansPerDegree;
  return points;
}

/// One direction and one curvature at every joint that is not a stop; lengths that agree with the points.
void expect_smooth(const Path& path, std::size_t stops) {
  std::size_t kinks = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Frame a = frame_at(path, i - 1, path.length[i - 1]), b = frame_at(path, i, 0);
    EXPECT_LE((a.point - b.point).norm(), 1e-9) << i;
    if ((a.first - b.first).norm() > 1e-6) {
      ++kinks;
      continue;
    }
    const double scale = 1 + std::max(a.second.norm(), b.second.norm());
    EXPECT_LE((a.second - b.second).norm(), 1e-5 * scale) << "node " << i;
  }
  EXPECT_EQ(kinks, stops);
}

// Simpson's rule with 20 000 intervals; its error is far below 1e-12 on these curves.
double reference_length(const CornerBlend& blend) {
  const int n = 20000;
  double sum = 0;
  for (int k = 0; k <= n; ++k) {
    const double weight = k == 0 || k == n ? 1 : k % 2 ? 4 : 2;
    sum += weight * blend_derivatives(blend, 1.0 * k / n).first.head<3>().norm();
  }
  return sum / n / 3;
}

TEST(CornerBlend, KnowsItsLengthToANinthAtEveryAngle) {
  for (double degrees : {0.01, 1.0, 30.0, 60.0, 90.0, 120.0, 150.0}) {
    const double a = degrees * std::numbers::pi / 180;
    const CornerBlend blend{at(1, 2), at(0.03, 0), at(0.03 * std::cos(a), 0.03 * std::sin(a))};
    const double expected = reference_length(blend);
    EXPECT_NEAR(blend_length(blend) / expected, 1, 1e-9) << degrees;
    for (double share : {0.1, 0.5, 0.77}) {
      const double t = blend_parameter(blend, blend_length(blend), share * blend_length(blend));
      EXPECT_NEAR(blend_length(blend, t) / expected, share, 1e-9) << degrees;
    }
  }
}

// Where only rotary axes turn at a corner its blend is straight.
TEST(CornerBlend, FindsEveryPlaceOnAStraightBlend) {
  CornerBlend blend{at(29, 9), at(0.957, 0), at(0.957, 0)};
  blend.before[5] = 0.0181;
  blend.after[5] = 0.0173;
  const double length = blend_length(blend);
  for (int k = 0; k <= 1000; ++k) {
    const double s = length * k / 1000;
    EXPECT_NEAR(blend_point(blend, blend_parameter(blend, length, s))[0], 29 - 0.957 + s, 1e-13) << k;
  }
}

// By hand: x(1/2) = corner + (after − before)/8.
TEST(CornerBlend, MissesTheCornerByAnEighthOfTheTurn) {
  const CornerBlend blend{at(0, 0), at(0.8, 0), at(0, 0.8)};
  EXPECT_LE((blend_point(blend, 0.5) - at(-0.1, 0.1)).norm(), 1e-15);
  EXPECT_EQ(blend_point(blend, 0), at(-0.8, 0));
  EXPECT_EQ(blend_point(blend, 1), at(0, 0.8));
}

TEST(CornerBlend, IsTheSameCurveAsOneOfDegreeFiveAndInHalves) {
  CornerBlend corner{at(1, 2, 3), at(0.8, 0), at(0.1, 0.7, -0.2)};
  corner.before[4] = 0.02;
  corner.after[4] = -0.05;
  const CurveBlend curve = as_curve_blend(corner);
  const auto [before, after] = halves(curve);
  for (int k = 0; k <= 16; ++k) {
    const double t = k / 16.0;
    const AxisVector expected = blend_point(corner, t);
    EXPECT_LE((blend_point(curve, t) - expected).norm(), 1e-14) << t;
    const AxisVector by_half = t < 0.5 ? blend_point(before, 2 * t) : blend_point(after, 2 * t - 1);
    EXPECT_LE((by_half - expected).norm(), 1e-14) << t;
  }
}

// A corner of 6 mm at either side: the slow block's feed ends where the curve passes the corner.
TEST(BlendPath, RunsEachHalfOfACornerAtTheFeedOfItsSide) {
  Moves moves;
  add_line(moves, at(20, 0), 100);
  add_line(moves, at(20, 20), 5);
  add_line(moves, at(40, 20), 5);
  const BlendedPath result = blended(moves, 1.0);
  ASSERT_EQ(result.path.size(), 6u);
  const std::uint32_t expected[] = {0, 0, 1, 1, 2, 2};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(result.path.move[i], expected[i]) << i;
  EXPECT_NEAR(result.path.length[1], result.path.length[2], 1e-12);
  // x(1/2) misses the corner by the tolerance, along the bisector.
  EXPECT_LE((result.path.node[2] - at(20 - std::sqrt(0.5), std::sqrt(0.5))).norm(), 1e-12);
  expect_smooth(result.path, 0);
  EXPECT_EQ(move_at(result.path, 1, 0.9 * result.path.length[1]), 0u);
  EXPECT_EQ(move_at(result.path, 2, 0.1 * result.path.length[2]), 1u);
}

TEST(BlendPath, UsesTheToleranceOfASquareCornerAndNoMore) {
  Moves moves;
  add_line(moves, at(10, 0));
  add_line(moves, at(10, 10));
  const BlendedPath result = blended(moves);
  ASSERT_EQ(result.path.size(), 3u);
  EXPECT_EQ(result.path.kind[1], SegmentKind::blend);
  EXPECT_NEAR(result.count.deviation, 0.01, 1e-12);
  expect_smooth(result.path, 0);
  const double middle = result.path.length[1] / 2;
  EXPECT_NEAR((point_at(result.path, 1, middle) - at(10, 0)).norm(), 0.01, 1e-9);
}

TEST(BlendPath, LetsAReversalAndASharpTurnStop) {
  Moves moves;
  add_line(moves, at(10, 0));
  add_line(moves, at(0, 0));
  add_line(moves, at(10, 1));
  const BlendedPath result = blended(moves);
  EXPECT_EQ(result.path.size(), 3u);
  EXPECT_EQ(result.count.stops, 2u);
}

TEST(BlendPath, JoinsALineAndATangentArcWithOneCurvature) {
  Moves moves;
  add_line(moves, at(10, 0));
  add_arc(moves, at(10, 10), {Eigen::Vector3d(10, 5, 0), Eigen::Vector3d::UnitZ(), std::numbers::pi});
  add_line(moves, at(0, 12));
  const BlendedPath result = blended(moves);
  expect_smooth(result.path, 0);
  EXPECT_EQ(result.count.corners, 2u);
  EXPECT_LE(result.count.deviation, 0.01);
  EXPECT_TRUE(test::frechet_within(sampled(result.path, 60), sampled(built(moves), 400), 0.0101));
}

TEST(BlendPath, MergesCollinearLines) {
  Moves moves;
  for (int i = 1; i <= 100; ++i) add_line(moves, at(0.02 * i, 0.04 * i));
  const BlendedPath result = blended(moves);
  EXPECT_EQ(result.path.size(), 4u);  // at most 32 in one
  EXPECT_EQ(result.count.merged, 96u);
  EXPECT_LE(result.count.deviation, 1e-12);
}

TEST(BlendPath, KeepsBlocksOfExactPathModeAndPausesAsTheyAre) {
  Moves moves;
  moves.modes.push_back({PathControl::exact_path, 0, 0, 17, 94});
  add_line(moves, at(10, 0));
  add_line(moves, at(10, 10), 100, 1);
  add_line(moves, at(0, 10));
  add_line(moves, at(0, 0));
  moves.kind.push_back(MoveKind::dwell);
  moves.line.push_back(9);
  moves.file.push_back(0);
  moves.mode.push_back(0);
  moves.detail.push_back(0);
  moves.end.push_back(at(0, 0));
  moves.feed.push_back(0);
  moves.dwells.push_back(0.5);
  add_line(moves, at(10, 0));
  const BlendedPath result = blended(moves);
  EXPECT_EQ(result.count.corners, 1u);  // at (0, 10) alone
  ASSERT_EQ(result.path.pauses.size(), 1u);
  EXPECT_EQ(result.path.node[result.path.pauses[0].node], at(0, 0));
}

TEST(BlendPath, RoundsOnlyBlocksUnderG64PWhereTheJobHasAnotherRule) {
  Moves moves;
  moves.modes.push_back({PathControl::blend, 0.05, 0, 17, 94});
  add_line(moves, at(10, 0));
  add_line(moves, at(10, 10));
  add_line(moves, at(0, 10), 100, 1);
  add_line(moves, at(0, 0), 100, 1);
  EXPECT_TRUE(asks_for_blends(moves));
  const BlendedPath result = blended(moves, 0.01, false);
  EXPECT_EQ(result.count.corners, 1u);
  EXPECT_NEAR(result.count.deviation, 0.05, 1e-12);
}

TEST(BlendPath, KeepsTheToleranceTheOrderAndTheCurvatureOnRandomPaths) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 engine(seed);
    const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
    const double scale = std::pow(10.0, -3 + 5 * uniform()), straight = uniform(), tolerance = 0.01;
    const bool rotary = seed % 5 == 0;
    Moves moves;
    AxisVector p = AxisVector::Zero();
    Eigen::Vector3d heading = Eigen::Vector3d::UnitX();
    for (int i = 0; i < 120; ++i) {
      heading =
          straight * heading + (1 - straight) * Eigen::Vector3d(2 * uniform() - 1, 2 * uniform() - 1, uniform() - 0.5);
      heading.normalize();
      p.head<3>() += heading * scale * std::pow(10.0, -uniform());
      if (rotary) p[3] += 0.01 * uniform();
      add_line(moves, p);
    }
    const BlendedPath result = blended(moves, tolerance);
    std::size_t kinks = 0;
    for (std::size_t i = 1; i < result.path.size(); ++i) {
      kinks += (end_direction(result.path, i - 1) - start_direction(result.path, i)).norm() > 1e-6;
    }
    EXPECT_LE(kinks, result.count.stops);
    expect_smooth(result.path, kinks);
    EXPECT_LE(result.count.deviation, tolerance * 1.0001);
    EXPECT_TRUE(test::frechet_within(sampled(result.path, 24), sampled(built(moves), 1), tolerance * 1.001));
  }
}

}  // namespace
}  // namespace toolpace
