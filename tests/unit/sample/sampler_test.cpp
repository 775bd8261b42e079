#include "toolpace/sample/sampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "toolpace/limits/limit_speed.h"
#include "toolpace/path/build_path.h"
#include "toolpace/plan/plan.h"
#include "toolpace/sample/axis_peaks.h"

namespace toolpace {
namespace {

AxisVector at(double x, double y, double z = 0) {
  AxisVector p = AxisVector::Zero();
  p.head<3>() << x, y, z;
  return p;
}

void add(Moves& moves, MoveKind kind, const AxisVector& end, std::uint32_t detail = kNoDetail) {
  moves.kind.push_back(kind);
  moves.line.push_back(static_cast<std::uint32_t>(10 * moves.size()));
  moves.file.push_back(0);
  moves.mode.push_back(0);
  moves.detail.push_back(detail);
  moves.end.push_back(end);
  moves.feed.push_back(50);
}

/// A line, an arc of 40° and a helix of one turn.
Moves mixed_program() {
  Moves moves;
  add(moves, MoveKind::feed, at(10, 0));
  const double angle = 40 * kRadiansPerDegree;
  add(moves, MoveKind::arc, at(10 + 5 * std::sin(angle), 5 - 5 * std::cos(angle)), 0);
  moves.arcs.push_back({Eigen::Vector3d(10, 5, 0), Eigen::Vector3d::UnitZ(), angle});
  const AxisVector begin = moves.end.back();
  add(moves, MoveKind::arc, begin + at(0, 0, 3), 1);
  moves.arcs.push_back({Eigen::Vector3d(10, 5, 0), Eigen::Vector3d::UnitZ(), 2 * std::numbers::pi});
  return moves;
}

struct Planned {
  Moves moves;
  Path path;
  MotionPlan plan;
};

Planned plan_of(Moves moves) {
  Planned p;
  p.moves = std::move(moves);
  p.path = *build_path(p.moves, 0);
  Machine machine;
  machine.path = {100, 3000, 3000, 1e6, 1e6};
  const auto limits = limit_speed(p.path, command_path(p.path, p.moves, command_options(machine)), machine, {});
  p.plan = *plan_motion(*limits, {});
  return p;
}

Planned plan_mixed() { return plan_of(mixed_program()); }

/// Distance of a point to the mixed program's geometry.
double off_path(const Path& path, const AxisVector& p) {
  double best = 1e9;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (path.kind[i] == SegmentKind::line) {
      const AxisVector u = path.node[i + 1] - path.node[i];
      const double t = std::clamp((p - path.node[i]).dot(u) / u.squaredNorm(), 0.0, 1.0);
      best = std::min(best, (p - path.node[i] - t * u).norm());
    } else {
      const ArcCurve& arc = path.arcs[path.detail[i]];
      const Eigen::Vector3d d = p.head<3>() - arc.centre;
      const double angle = std::atan2(arc.lateral.dot(d), arc.radial.dot(d));
      for (const double turned : {angle, angle + 2 * std::numbers::pi}) {
        best = std::min(best, (arc_point(arc, std::clamp(turned, 0.0, arc.sweep)) - p).norm());
      }
    }
  }
  return best;
}

TEST(Sampler, FirstAndLastRowAreTheExactEnds) {
  const Planned p = plan_mixed();
  Sampler sampler(p.path, p.plan, p.moves, 0.001);
  Setpoints all;
  ASSERT_TRUE(sampler.next(all, 1000000));
  ASSERT_EQ(all.size(), sampler.rows());
  const std::size_t last = all.size() - 1;
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(all.position[k][0], p.path.node.front()[static_cast<Eigen::Index>(k)]);
    EXPECT_EQ(all.position[k][last], p.path.node.back()[static_cast<Eigen::Index>(k)]);
  }
  EXPECT_GE(all.time(last), p.plan.cycle_time() - 1e-12);
  EXPECT_LT(all.time(last - 1), p.plan.cycle_time());
  EXPECT_EQ(all.speed[last], 0);
}

TEST(Sampler, EveryPointLiesOnThePath) {
  const Planned p = plan_mixed();
  Sampler sampler(p.path, p.plan, p.moves, 0.001);
  Setpoints chunk;
  while (sampler.next(chunk, 100)) {
    for (std::size_t i = 0; i < chunk.size(); ++i) {
      const AxisVector point = at(chunk.position[0][i], chunk.position[1][i], chunk.position[2][i]);
      EXPECT_LE(off_path(p.path, point), 1e-9) << "row " << chunk.first_row + i;
    }
  }
}

TEST(Sampler, SpeedColumnAgreesWithDifferencesOfThePositions) {
  const Planned p = plan_mixed();
  constexpr double kPeriod = 1e-4;
  Sampler sampler(p.path, p.plan, p.moves, kPeriod);
  Setpoints all;
  sampler.next(all, 10000000);
  for (std::size_t i = 1; i + 2 < all.size(); ++i) {
    if (all.line[i - 1] != all.line[i + 1]) continue;  // across the corner from arc to helix the chord is shorter
    const AxisVector step =
        at(all.position[0][i + 1] - all.position[0][i - 1], all.position[1][i + 1] - all.position[1][i - 1],
           all.position[2][i + 1] - all.position[2][i - 1]);
    // Central difference: off by |j|·Ts²/6 along the path and by the chord of the arc across it.
    EXPECT_NEAR(step.norm() / (2 * kPeriod), all.speed[i], 1e6 * kPeriod * kPeriod + 1e-3) << "row " << i;
  }
}

TEST(Sampler, ChunksOfAnySizeGiveTheSameRows) {
  const Planned p = plan_mixed();
  Sampler whole(p.path, p.plan, p.moves, 0.001), pieces(p.path, p.plan, p.moves, 0.001);
  Setpoints all, chunk;
  whole.next(all, 1000000);
  std::size_t row = 0;
  while (pieces.next(chunk, 7)) {
    EXPECT_EQ(chunk.first_row, row);
    for (std::size_t i = 0; i < chunk.size(); ++i, ++row) {
      EXPECT_EQ(chunk.position[0][i], all.position[0][row]);
      EXPECT_EQ(chunk.line[i], all.line[row]);
    }
  }
  EXPECT_EQ(row, all.size());
}

TEST(Sampler, SeekGoesOnAtTheRow) {
  const Planned p = plan_mixed();
  Sampler whole(p.path, p.plan, p.moves, 0.001), jumping(p.path, p.plan, p.moves, 0.001);
  Setpoints all, chunk;
  whole.next(all, 1000000);
  for (const std::size_t row : {all.size() - 1, all.size() / 2, std::size_t{3}}) {
    jumping.seek(row);
    ASSERT_TRUE(jumping.next(chunk, 1));
    EXPECT_EQ(chunk.position[1][0], all.position[1][row]);
    EXPECT_EQ(chunk.speed[0], all.speed[row]);
  }
}

// At constant speed v on a circle of radius r the sagitta is (v·Ts)²/(8r); the feed is 50 mm/s, r = 5, Ts = 2 ms.
TEST(Sampler, ChordErrorOnAnArcIsTheSagitta) {
  Moves circle;
  add(circle, MoveKind::arc, at(0, 0), 0);
  circle.arcs.push_back({Eigen::Vector3d(0, 5, 0), Eigen::Vector3d::UnitZ(), 2 * std::numbers::pi});
  const Planned p = plan_of(circle);
  Sampler sampler(p.path, p.plan, p.moves, 0.002);
  sampler.measure_chords();
  Setpoints chunk;
  while (sampler.next(chunk)) continue;
  EXPECT_NEAR(sampler.largest_chord_error(), 0.1 * 0.1 / 40, 0.02 * 0.1 * 0.1 / 40);
}

TEST(ChordErrorMeter, ACornerBetweenTwoSetpointsIsMeasuredExactly) {
  Path path;
  path.kind = {SegmentKind::line, SegmentKind::line};
  path.length = {1, 1};
  path.move = {0, 0};
  path.detail = {kNoDetail, kNoDetail};
  path.node = {at(0, 0), at(1, 0), at(1, 1)};
  ChordErrorMeter meter(path);
  meter.add(0, 0.5, at(0.5, 0));
  meter.add(1, 0.5, at(1, 0.5));
  EXPECT_NEAR(meter.largest(), 0.5 / std::sqrt(2), 1e-15);
}

TEST(Sampler, ADurationOfWholePeriodsHasNoExtraRow) {
  EXPECT_EQ(row_count(0.3, 0.1), 4u);  // 0.3/0.1 is 2.9999999999999996
  EXPECT_EQ(row_count(0.7, 0.1), 8u);
  EXPECT_EQ(row_count(0.71, 0.1), 9u);
  EXPECT_EQ(row_count(0.0, 0.1), 1u);
}

TEST(AxisPeaks, SingleStepHasTheDifferencesOfAStep) {
  // 0 → 1 mm in one period of 1 s, at rest before and after: v 1, a ±1, j −2 (by hand).
  Setpoints rows;
  rows.period = 1;
  rows.position[0] = {0, 1};
  AxisPeakMeter meter;
  meter.add(rows);
  EXPECT_EQ(meter.peaks()[0].speed, 1);
  EXPECT_EQ(meter.peaks()[0].acceleration, 1);
  EXPECT_EQ(meter.peaks()[0].jerk, 2);
  EXPECT_TRUE(meter.has_moved(0));
  EXPECT_FALSE(meter.has_moved(1));
}

}  // namespace
}  // namespace toolpace
