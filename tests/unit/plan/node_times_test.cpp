#include <gtest/gtest.h>

#include "plan_cases.h"
#include "toolpace/plan/plan.h"

namespace toolpace {
namespace {

TEST(NodeTimes, AgreeWithTheDistanceThatThePlanHasCovered) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const SpeedLimits limits = test::random_chain(seed, 200);
    const auto plan = plan_motion(limits, PlanOptions{});
    ASSERT_TRUE(plan);
    const auto times = node_times(limits, *plan);
    const auto positions = node_positions(limits);
    ASSERT_EQ(times.size(), limits.size() + 1);
    EXPECT_EQ(times.front(), 0.0);
    EXPECT_EQ(times.back(), plan->cycle_time());
    std::size_t k = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
      ASSERT_GE(times[i], times[i - (i > 0)]);
      while (k + 1 < plan->phases.size() && plan->phases[k + 1].begin <= times[i]) ++k;
      const Phase& p = plan->phases[k];
      EXPECT_NEAR(positions[p.node] + evaluate(p, times[i] - p.begin).distance, positions[i], 1e-9 * positions.back())
          << seed << " " << i;
    }
  }
}

// A dwell is a phase that goes nowhere: the node under it is reached when it begins.
TEST(NodeTimes, ReachANodeBeforeItsDwell) {
  const SpeedLimits limits = test::line_of({1, 1}, {10, 10}, test::symmetric(100, 1e4));
  PlanOptions options;
  options.lookahead = 1;
  auto plan = plan_motion(limits, options);
  ASSERT_TRUE(plan);
  const double arrival = node_times(limits, *plan)[1];
  MotionPlan paused;
  for (const Phase& p : plan->phases) {
    if (p.node == 1 && paused.phases.back().node == 0) {
      paused.phases.push_back({p.begin, 0.5, 0, 0, 0, 0, PhaseShape::constant_jerk, 1});
    }
    paused.phases.push_back(p);
    if (p.node == 1) paused.phases.back().begin += 0.5;
  }
  const auto times = node_times(limits, paused);
  EXPECT_DOUBLE_EQ(times[1], arrival);
  EXPECT_DOUBLE_EQ(times[2], plan->cycle_time() + 0.5);
}

}  // namespace
}  // namespace toolpace
