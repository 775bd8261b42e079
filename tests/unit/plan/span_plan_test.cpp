#include <gtest/gtest.h>

#include <cmath>

#include "plan_cases.h"
#include "plan_checker.h"
#include "toolpace/bound/path_bound.h"
#include "toolpace/plan/plan.h"

namespace toolpace {
namespace {

using test::symmetric;

double cycle_time(const SpeedLimits& limits, LawKind law = LawKind::seven_phase) {
  PlanOptions options;
  options.law = law;
  options.ramps = Ramps::span;
  const auto plan = plan_motion(limits, options);
  if (!plan) {
    ADD_FAILURE() << plan.error().message;
    return -1;
  }
  EXPECT_EQ(test::find_offence(limits, *plan), "");
  return plan->cycle_time();
}

// No jerk-limited plan can beat 0.3364 s (convex relaxation); with zero acceleration at every node the best is 0.3396
// s.
TEST(SpanPlan, RunsTheTwentyBlocksFasterThanAnyPlanThatRestsItsAccelerationAtNodes) {
  const double t = cycle_time(test::ning_blocks(symmetric(3000, 1e6)));
  EXPECT_LE(t, 0.3370);
  EXPECT_GE(t, 0.3364);
}

struct ButterflyFigure {
  double step, jerk, at_most, bound;
};

class SpanPlanOfTheButterfly : public ::testing::TestWithParam<ButterflyFigure> {};

TEST_P(SpanPlanOfTheButterfly, ComesCloseToTheProvenBound) {
  const ButterflyFigure& f = GetParam();
  test::PolylineRules rules{symmetric(294.2, f.jerk)};
  rules.corner_step = f.step;
  const SpeedLimits limits = test::limits_of(test::polyline("butterfly588"), rules);
  const double t = cycle_time(limits);
  EXPECT_LE(t, f.at_most);
  EXPECT_GE(t, f.bound);
}

INSTANTIATE_TEST_SUITE_P(
    Figures, SpanPlanOfTheButterfly,
    ::testing::Values(ButterflyFigure{1e9, 1e6, 3.218, 3.217}, ButterflyFigure{1e9, 3e4, 3.228, 3.226},
                      ButterflyFigure{1e9, 1e4, 3.248, 3.244}, ButterflyFigure{0.739, 1e6, 9.459, 9.424},
                      ButterflyFigure{0.739, 3e4, 10.09, 9.781}, ButterflyFigure{0.739, 1e4, 10.37, 9.612}));

TEST(SpanPlan, OfTheQuinticCostsLessThanItsBlockRamps) {
  test::PolylineRules rules{symmetric(294.2, 3e4)};
  rules.corner_step = 0.739;
  const SpeedLimits limits = test::limits_of(test::polyline("butterfly588"), rules);
  EXPECT_LE(cycle_time(limits, LawKind::quintic), 10.70);  // 10.98 in blocks
}

// v·a/J + a³/3J² until the acceleration is gone, then the law's own stop from v + a²/2J, within the next N − 1 blocks.
TEST(SpanPlan, CanStopInsideItsWindowAtEveryNode) {
  const double deceleration = 500, jerk = 2e4;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SpeedLimits limits = test::random_chain(seed, 80);
    limits.dynamics = {symmetric(deceleration, jerk)};
    const auto position = node_positions(limits);
    for (const std::size_t blocks : {1u, 2u, 3u, 6u, 15u}) {
      PlanOptions options;
      options.law = LawKind::seven_phase;
      options.ramps = Ramps::span;
      options.lookahead = blocks;
      const auto plan = plan_motion(limits, options);
      const auto time = node_times(limits, *plan);
      std::size_t k = 0;
      for (std::size_t i = 1; i + blocks - 1 < limits.size(); ++i) {
        while (k + 1 < plan->phases.size() && plan->phases[k + 1].begin <= time[i]) ++k;
        const PhaseState there = evaluate(plan->phases[k], time[i] - plan->phases[k].begin);
        const double a = std::max(0.0, there.acceleration), v = there.speed + a * a / (2 * jerk);
        const double ramp =
            v * jerk > deceleration * deceleration ? v / deceleration + deceleration / jerk : 2 * std::sqrt(v / jerk);
        const double stop = there.speed * a / jerk + a * a * a / (3 * jerk * jerk) + v / 2 * ramp;
        EXPECT_LE(stop, (position[i + blocks - 1] - position[i]) * (1 + 1e-6) + 1e-6)
            << "seed " << seed << " node " << i;
      }
    }
  }
}

// Micro-segments in a plane of 3000 mm/s² between plunges of an axis that does 300: one set of limits for all of it
// would make the whole path as slow as the slow axis.
TEST(SpanPlan, DoesNotCarryASlowAxisIntoTheBlocksOfAFastOne) {
  SpeedLimits limits;
  limits.dynamics = {symmetric(3000, 1e6), symmetric(300, 5e4)};
  const auto add = [&](double length, double feed, std::uint32_t ramp, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      limits.length.push_back(length);
      limits.block_cap.push_back(feed);
      limits.ramp.push_back(ramp);
      limits.node_cap.push_back(i == 0 ? 1.0 : 1e9);
    }
  };
  for (int k = 0; k < 10; ++k) {
    add(0.05, 80, 0, 400);
    add(1, 15, 1, 5);
  }
  limits.node_cap.push_back(0);
  limits.node_cap[0] = 0;
  limits.block_cause.assign(limits.size(), Cause::feed);
  limits.node_cause.assign(limits.size() + 1, Cause::corner);
  EXPECT_LE(cycle_time(limits), path_bound(limits, LawKind::seven_phase) * 1.02);
}

TEST(SpanPlan, RunsLineAndCircleAsTheLimitsAllow) {
  test::PolylineRules rules{symmetric(INFINITY, INFINITY)};
  rules.axis_acceleration = 2000;
  rules.axis_jerk = 5e4;
  rules.axis_speed = 100;
  rules.servo_acceleration = 2000;
  const SpeedLimits line = test::limits_of(test::polyline("line"), rules);
  const SpeedLimits circle = test::limits_of(test::polyline("circle"), rules);
  EXPECT_LE(cycle_time(line), 1.091);
  EXPECT_LE(cycle_time(circle), 5.10);
}

// By hand: 10 mm, J 1e4, A 1e9, no cap in the way: up and down with √(JΔ) at the middle, R = vp·√(vp/J) = 5 mm
// gives vp = (25·1e4)^⅓ = 62.996 mm/s and T = 4·√(vp/J) = 0.31748 s, however the 10 mm are cut into blocks.
TEST(SpanPlan, DoesNotFeelNodesThatRestrainNothing) {
  for (const std::size_t blocks : {1u, 2u, 7u, 1000u}) {
    const std::vector<double> length(blocks, 10.0 / static_cast<double>(blocks));
    const std::vector<double> feed(blocks, 1000.0);
    EXPECT_NEAR(cycle_time(test::line_of(length, feed, symmetric(1e9, 1e4))), 4 * std::sqrt(std::cbrt(25e4) / 1e4),
                1e-9);
  }
}

TEST(SpanPlan, KeepsEveryLimitOnRandomChains) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    for (const bool mixed : {false, true}) {
      const SpeedLimits limits = test::random_chain(seed, 100, mixed);
      const double span = cycle_time(limits);
      PlanOptions block;
      block.law = LawKind::seven_phase;
      EXPECT_LE(span, plan_motion(limits, block)->cycle_time() * 1.001) << "seed " << seed;
    }
  }
}

// Chords whose limits change by a factor of ten from one to the next, without a stop: 40 rounds of them and 1200, which is
// enough for the way of planning to be chosen by samples. The ends, where the chain starts and stops, are left out.
TEST(SpanPlan, IsAsFastInLongChainsOfVeryDifferentLimits) {
  constexpr std::size_t kRound = 50;
  const auto chain = [&](std::size_t rounds) {
    SpeedLimits limits;
    limits.dynamics = {symmetric(3000, 5e4), symmetric(300, 5e3)};
    for (std::size_t i = 0; i < rounds * kRound; ++i) {
      const std::size_t k = i % kRound;
      limits.length.push_back(0.1 + 0.02 * static_cast<double>(k % 7));
      limits.block_cap.push_back(20 + static_cast<double>(k % 11));
      limits.ramp.push_back(k % 5 == 0 ? 1 : 0);
      limits.node_cap.push_back(i == 0 ? 0.0 : 1e9);
    }
    limits.node_cap.push_back(0);
    limits.block_cause.assign(limits.size(), Cause::feed);
    limits.node_cause.assign(limits.size() + 1, Cause::corner);
    return limits;
  };
  const double ends = cycle_time(chain(40)), twice = cycle_time(chain(80));
  EXPECT_LE(cycle_time(chain(1200)), (ends + 29 * (twice - ends)) * 1.001);
}

}  // namespace
}  // namespace toolpace
