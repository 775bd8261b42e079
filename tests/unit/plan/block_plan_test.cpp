#include <gtest/gtest.h>

#include <cmath>

#include "plan_cases.h"
#include "plan_checker.h"
#include "toolpace/law/law_table.h"
#include "toolpace/plan/plan.h"

namespace toolpace {
namespace {

using test::symmetric;

double cycle_time(const SpeedLimits& limits, PlanOptions options) {
  const auto plan = plan_motion(limits, options);
  if (!plan) {
    ADD_FAILURE() << plan.error().message;
    return -1;
  }
  test::CheckOptions check;
  check.jerk = options.law != LawKind::trapezoid;
  check.continuous_acceleration = check.jerk;
  EXPECT_EQ(test::find_offence(limits, *plan, check), "");
  return plan->cycle_time();
}

struct DepthFigure {
  std::optional<std::size_t> blocks;
  double milliseconds;
};

// Ning et al. 2014 print 1048.5 ms for N = 1 and, with unpublished corners, 502.7 and 439.3 for 2 and 4; the figures
// here are those of the same law with all corners straight, computed independently.
TEST(BlockPlan, ReproducesThePapersTwentyBlocksAtEachDepth) {
  const SpeedLimits limits = test::ning_blocks(symmetric(3000, 1e6));
  for (const auto& [blocks, milliseconds] : {DepthFigure{1, 1047.844}, DepthFigure{2, 441.048}, DepthFigure{4, 369.350},
                                             DepthFigure{8, 368.981}, DepthFigure{std::nullopt, 368.981}}) {
    PlanOptions options;
    options.lookahead = blocks;
    EXPECT_NEAR(1e3 * cycle_time(limits, options), milliseconds, 0.01) << "N = " << blocks.value_or(0);
  }
}

TEST(BlockPlan, ReproducesThePapersButterfly) {
  test::PolylineRules rules{symmetric(294.2, 1e6)};
  rules.servo_acceleration = 294.2;
  rules.period = 0.004;
  const SpeedLimits limits = test::limits_of(test::polyline("butterfly588"), rules);
  ASSERT_EQ(limits.size(), 588u);
  PlanOptions options;
  options.lookahead = 1;
  const double stop_everywhere = cycle_time(limits, options);
  EXPECT_NEAR(stop_everywhere, 45.31, 0.005);
  options.lookahead = 8;
  EXPECT_GE(1 - cycle_time(limits, options) / stop_everywhere, 0.7731);
}

TEST(BlockPlan, CostsWhatIsKnownWithZeroAccelerationAtEveryNode) {
  test::PolylineRules rules{symmetric(294.2, 3e4)};
  rules.corner_step = 0.739;
  const SpeedLimits limits = test::limits_of(test::polyline("butterfly588"), rules);
  PlanOptions options;
  EXPECT_NEAR(cycle_time(limits, options), 10.987, 0.01);  // the best possible is 10.987 for the quintic
  options.law = LawKind::seven_phase;
  EXPECT_NEAR(cycle_time(limits, options), 10.535, 0.01);
}

// With J = 3e4 a speed of 3.61 mm/s can be brought to 0 in a block in which it cannot be brought to 0.5: windows that
// end at rest commit speeds which the next window cannot continue as it would like.
TEST(BlockPlan, SurvivesTheTrapOfShrinkingRampsAtEveryDepth) {
  test::PolylineRules rules{symmetric(294.2, 3e4)};
  rules.corner_step = 0.739;
  const SpeedLimits limits = test::limits_of(test::polyline("butterfly588"), rules);
  for (const LawRow& row : law_table()) {
    PlanOptions options;
    options.law = row.kind;
    double last = 1e300;
    for (const std::size_t blocks : {1, 2, 3, 4, 5, 6, 8, 12, 20, 50, 588}) {
      options.lookahead = blocks;
      SpeedLimits timed = limits;
      timed.dynamics[0].up.time = timed.dynamics[0].down.time = 0.01;
      const double t = cycle_time(timed, options);
      EXPECT_LT(t, last * 1.02) << row.id << " N = " << blocks;
      last = t;
    }
  }
}

TEST(BlockPlan, NeedsOnlyOneRampForABlockThatChangesTheSpeedExactly) {
  // By hand: trapezoid from 0 to 10 at 100 mm/s² takes 0.5 mm and 0.1 s; 1 mm at 10 mm/s takes 0.1 s; and back.
  SpeedLimits limits = test::line_of({0.5, 1.0, 0.5}, {10, 10, 10}, symmetric(100, 1e9));
  PlanOptions options;
  options.law = LawKind::trapezoid;
  const auto plan = plan_motion(limits, options);
  ASSERT_TRUE(plan);
  ASSERT_EQ(plan->phases.size(), 3u);
  EXPECT_NEAR(plan->cycle_time(), 0.3, 1e-12);
}

// Zheng's gap: 5 mm at Tacc = 0.1 s allow from rest up to 2·5/0.1 = 100 mm/s; 1 mm from 50 mm/s allows 50 and 0 … −30:
// 50 alone.
TEST(BlockPlan, KeepsOutOfTheGapOfFixedRampTimes) {
  const auto dynamics = symmetric(1e6, 1e9, 0.1);
  SpeedLimits limits = test::line_of({5, 1, 5}, {50, 90, 50}, dynamics);
  PlanOptions options;
  options.law = LawKind::five_phase_time;
  EXPECT_NEAR(cycle_time(limits, options), 2 * (0.1 + 2.5 / 50) + 1.0 / 50, 1e-9);
}

TEST(BlockPlan, SaysWhatIsUnboundedOrCannotMove) {
  SpeedLimits limits = test::line_of({1}, {10}, symmetric(INFINITY, 1e6));
  PlanOptions options;
  options.law = LawKind::seven_phase;
  EXPECT_EQ(plan_motion(limits, options).error().code, "limits-unbounded");
  limits = test::line_of({1}, {10}, {{100, 1e6, 0}, {100, INFINITY, 0}});
  EXPECT_EQ(
      plan_motion(limits, options).error().message,
      "--jd (max_jerk_deceleration_mm_s3 in [path]) is inf, and nothing else bounds the jerk, which seven-phase needs");
  limits = test::line_of({1}, {0}, symmetric(100, 1e6));
  EXPECT_EQ(plan_motion(limits, options).error().code, "feed-zero");
  limits = test::line_of({1}, {INFINITY}, symmetric(100, 1e6));
  EXPECT_EQ(plan_motion(limits, options).error().code, "limits-unbounded");
  limits = test::line_of({1}, {10}, symmetric(100, 1e6));
  options.lookahead = 0;
  EXPECT_EQ(plan_motion(limits, options).error().code, "lookahead-zero");
  EXPECT_TRUE(plan_motion(test::line_of({}, {}, symmetric(1, 1)), PlanOptions{})->phases.empty());
  limits.length[0] = -1;
  EXPECT_THROW((void)plan_motion(limits, PlanOptions{}), std::invalid_argument);
}

TEST(BlockPlan, StopsWhenCancelled) {
  const SpeedLimits limits = test::random_chain(1, 1000);
  std::stop_source source;
  source.request_stop();
  const auto plan = plan_motion(limits, PlanOptions{}, Monitor{source.get_token(), {}});
  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().kind, ErrorKind::cancelled);
}

}  // namespace
}  // namespace toolpace
