/// Turning back: at rest, but not without acceleration.

#include "toolpace/plan/span/turns.h"

#include <gtest/gtest.h>

#include <cmath>

#include "plan_cases.h"
#include "plan_checker.h"
#include "toolpace/bound/path_bound.h"
#include "toolpace/plan/plan.h"

namespace toolpace {
namespace {

using test::symmetric;

constexpr double kJerk = 5e4;

/// Strokes to and fro.
SpeedLimits strokes(const std::vector<double>& length, double feed, double acceleration) {
  SpeedLimits limits = test::line_of(length, std::vector<double>(length.size(), feed), symmetric(acceleration, kJerk));
  for (std::uint32_t node = 1; node < length.size(); ++node) {
    limits.node_cap[node] = 0;
    limits.reversals.push_back(node);
  }
  return limits;
}

double time_of(const SpeedLimits& limits, LawKind law = LawKind::seven_phase, Ramps ramps = Ramps::span) {
  PlanOptions options;
  options.law = law;
  options.ramps = ramps;
  const auto plan = plan_motion(limits, options);
  EXPECT_EQ(test::find_offence(limits, *plan), "");
  EXPECT_GE(plan->cycle_time(), path_bound(limits, law));
  return plan->cycle_time();
}

// By hand, stroke of 3 mm between two turns under 2000 mm/s² and 5e4 mm/s³: it holds 2000 for τ, lets it fall to −2000 in 80 ms,
// and holds that for τ. The fall alone takes (2/3)·2000³/5e4² = 2.1333 mm; 2000·τ² + 2000·τ·0.08 + 2.1333 = 3 gives
// τ = 5.09247 ms and 90.1850 ms a stroke. From rest to rest it takes 4·∛(3/(2·5e4)) = 124.2893 ms.
TEST(Turns, StrokesTurnWithTheAccelerationThatTheyBrakeWith) {
  constexpr double kStroke = 0.0901850, kRested = 0.1242893;
  const std::vector<double> six(6, 3.0), five(5, 3.0);
  EXPECT_NEAR(time_of(strokes(six, 100, 2000)) - time_of(strokes(five, 100, 2000)), kStroke, 1e-6);
  SpeedLimits rested = strokes(six, 100, 2000);
  rested.reversals.clear();
  EXPECT_NEAR(time_of(rested), 6 * kRested, 1e-6);
}

// Between two turns that jerk alone limits a stroke of (2/3)·a³/J² lasts 2a/J: of 1 mm, a = 1554 mm/s² and 62.1 ms. The room
// that a turn leaves its block for other ends costs no thousandth of that.
TEST(Turns, ShortStrokesAreLimitedByJerkAlone) {
  const std::vector<double> six(6, 1.0), five(5, 1.0);
  const double stroke = time_of(strokes(six, 100, 1e4)) - time_of(strokes(five, 100, 1e4));
  EXPECT_NEAR(stroke, 2 * std::cbrt(1.5 / kJerk), 1e-3 * stroke);
}

// By hand: at a feed of 10 mm/s a turn has a²/2J of speed to give, 1000 mm/s². It is at the feed after 20 ms and 1000·0.02²/2 −
// 5e4·0.02³/6 = 0.13333 mm, a rest after 2·√(10/5e4) = 28.284 ms and 0.14142 mm; so 5 mm take 0.02 + 0.028284 + 0.472525 s.
TEST(Turns, TakeNoMoreAccelerationThanTheFeedLetsThemGiveBack) {
  const auto turns = detail::possible_turns(strokes({5, 5}, 10, 2000), {0, 0, 0}, {1});
  ASSERT_EQ(turns.size(), 1u);
  EXPECT_NEAR(turns[0].acceleration, 1000, 1e-2);
  EXPECT_NEAR(time_of(strokes({5, 5}, 10, 2000)), 2 * 0.520809, 2e-6);
}

TEST(Turns, AreNotForThoseThatRestAtTheirNodesByDefinition) {
  const SpeedLimits turning = strokes({3, 3, 3}, 100, 2000);
  SpeedLimits rested = turning;
  rested.reversals.clear();
  for (const LawKind law : {LawKind::five_phase_jerk, LawKind::quintic}) {
    EXPECT_EQ(time_of(turning, law), time_of(rested, law));
  }
  EXPECT_EQ(time_of(turning, LawKind::seven_phase, Ramps::block), time_of(rested, LawKind::seven_phase, Ramps::block));
}

TEST(Turns, NeverRunBackwardsNorPassTheirNode) {
  const SpeedLimits limits = strokes({3, 0.02, 40, 1, 1, 0.5, 7}, 100, 2000);
  PlanOptions options;
  options.law = LawKind::time_optimal;
  options.ramps = Ramps::span;
  const auto plan = plan_motion(limits, options);
  const NodePositions position = node_positions(limits);
  std::size_t turns = 0;
  for (std::size_t k = 0; k < plan->phases.size(); ++k) {
    const Phase& p = plan->phases[k];
    EXPECT_GE(extrema(p).min_speed, -1e-9);
    if (k == 0 || !(p.speed == 0 && p.acceleration > 0)) continue;
    const Phase& last = plan->phases[k - 1];
    const PhaseState before = evaluate(last, last.duration);
    EXPECT_NEAR(before.distance, position.between(last.node, p.node), 1e-14);
    EXPECT_EQ(p.distance, 0);
    EXPECT_NEAR(before.acceleration, -p.acceleration, 1e-9);
    ++turns;
  }
  EXPECT_EQ(turns, 6u);
}

TEST(Turns, LeaveAWindowOfBlocksRoomToStopIn) {
  const SpeedLimits limits = strokes({3, 0.5, 3, 0.02, 0.02, 3}, 100, 2000);
  double last = 1e300;
  for (std::size_t depth = 1; depth <= 7; ++depth) {
    PlanOptions options;
    options.law = LawKind::seven_phase;
    options.ramps = Ramps::span;
    options.lookahead = depth;
    const auto plan = plan_motion(limits, options);
    EXPECT_EQ(test::find_offence(limits, *plan), "");
    EXPECT_LE(plan->cycle_time(), last * (1 + 1e-13));
    last = plan->cycle_time();
  }
  EXPECT_EQ(last, time_of(limits));
}

}  // namespace
}  // namespace toolpace
