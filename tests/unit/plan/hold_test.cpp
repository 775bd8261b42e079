#include "toolpace/plan/hold.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "plan_cases.h"
#include "plan_checker.h"
#include "toolpace/law/law_table.h"
#include "toolpace/plan/plan.h"

namespace toolpace {
namespace {

using test::symmetric;

/// Where the plan of one block rests for exactly `pause`.
double resting_place(const MotionPlan& plan, double pause) {
  for (const Phase& p : plan.phases) {
    if (p.speed == 0 && p.rate == 0 && p.acceleration == 0 && p.duration == pause) return p.distance;
  }
  return -1;
}

// By hand: at 50 mm/s, 500 mm/s² and 1e4 mm/s³ a stop takes 50/500 + 500/1e4 = 0.15 s and 50/2·0.15 = 3.75 mm.
TEST(FeedHold, BrakesWithFullJerkOutOfACruise) {
  const SpeedLimits limits = test::line_of({100}, {50}, symmetric(500, 1e4));
  for (const LawKind law : {LawKind::seven_phase, LawKind::quintic}) {
    PlanOptions options;
    options.law = law;
    const auto plan = plan_motion(limits, options);
    const auto held = insert_hold(limits, *plan, options, {1.0, 2.5});
    ASSERT_TRUE(held);
    const double ramp = 50.0 / 2 * (law == LawKind::quintic ? 15 * 50.0 / (8 * 500) : 0.15);
    const double at_hold = ramp + 50 * (1.0 - ramp * 2 / 50);
    EXPECT_NEAR(resting_place(*held, 2.5), at_hold + 3.75, 1e-9);
    EXPECT_EQ(test::find_offence(limits, *held), "");
  }
}

TEST(FeedHold, BrakesAtConstantDecelerationWithoutJerkLimit) {
  const SpeedLimits limits = test::line_of({100}, {50}, symmetric(500, 1e4));
  PlanOptions options;
  options.law = LawKind::trapezoid;
  const auto plan = plan_motion(limits, options);
  const auto held = insert_hold(limits, *plan, options, {1.0, 0.5});
  // 0.1 s and 2.5 mm up to speed, 45 mm more by 1 s, 2.5 mm to stop; then 2·2.5 mm ramps and 47.5… at 50.
  EXPECT_NEAR(resting_place(*held, 0.5), 50.0, 1e-9);
  EXPECT_NEAR(held->cycle_time(), 1.0 + 0.1 + 0.5 + 0.2 + 45.0 / 50, 1e-9);
}

TEST(FeedHold, StaysInsideEveryLimitWheneverItComes) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const SpeedLimits limits = test::random_chain(seed, 40, seed % 2 == 0);
    for (const LawRow& law : law_table()) {
      for (const Ramps ramps : {Ramps::block, Ramps::span}) {
        PlanOptions options;
        options.law = law.kind;
        options.ramps = ramps;
        const auto plan = plan_motion(limits, options);
        for (const double share : {0.0, 0.1, 0.25, 0.5, 0.77, 0.99, 0.999999}) {
          const auto held = insert_hold(limits, *plan, options, {share * plan->cycle_time(), 0.125});
          ASSERT_TRUE(held);
          EXPECT_GE(held->cycle_time(), share * plan->cycle_time() + 0.125);
          const test::CheckOptions check{law.bounds_jerk, law.bounds_jerk, 1e-6};
          EXPECT_EQ(test::find_offence(limits, *held, check), "") << law.id << " seed " << seed << " at " << share;
        }
      }
    }
  }
}

TEST(FeedHold, KeepsThePausesBehindItAndLengthensTheOneItFallsInto) {
  SpeedLimits limits = test::line_of({10, 10}, {50, 50}, symmetric(500, 1e4));
  limits.node_cap[1] = 0;
  PlanOptions options;
  const auto plan = plan_motion(limits, options);
  const double arrival = node_times(limits, *plan)[1];
  MotionPlan paused;
  for (Phase p : plan->phases) {
    if (p.begin >= arrival) {
      if (paused.phases.back().begin < arrival) paused.phases.push_back({arrival, 3.0, 10.0, 0, 0, 0, {}});
      p.begin += 3.0;
    }
    paused.phases.push_back(p);
  }
  const auto before = insert_hold(limits, paused, options, {arrival / 2, 1.0});
  ASSERT_TRUE(before);
  EXPECT_EQ(resting_place(*before, 3.0), 10.0);
  EXPECT_EQ(test::find_offence(limits, *before), "");
  const auto during = insert_hold(limits, paused, options, {arrival + 1.0, 1.0});
  ASSERT_TRUE(during);
  EXPECT_NEAR(during->cycle_time(), paused.cycle_time() + 1.0, 1e-9);
}

TEST(FeedHold, AtAMomentThatNoClockTellsFromTheStartIsOneAtTheStart) {
  const SpeedLimits limits = test::line_of({10}, {50}, symmetric(500, 1e4));
  for (const LawRow& law : law_table()) {
    PlanOptions options;
    options.law = law.kind;
    const auto plan = plan_motion(limits, options);
    for (const double time : {0.0, 5e-324, 1e-310, 1e-300, 1e-20}) {
      const auto held = insert_hold(limits, *plan, options, {time, 1.0});
      ASSERT_TRUE(held) << law.id << " at " << time;
      EXPECT_NEAR(held->cycle_time(), plan->cycle_time() + 1.0, 1e-9) << law.id << " at " << time;
      const std::string offence = law.bounds_jerk ? test::find_offence(limits, *held) : "";
      EXPECT_EQ(offence, "") << law.id << " at " << time;
    }
  }
}

TEST(FeedHold, RefusesATimeBehindTheEnd) {
  const SpeedLimits limits = test::line_of({10}, {50}, symmetric(500, 1e4));
  const auto plan = plan_motion(limits, PlanOptions{});
  const auto held = insert_hold(limits, *plan, PlanOptions{}, {1e3, 1.0});
  ASSERT_FALSE(held);
  EXPECT_EQ(held.error().code, "hold-after-end");
  EXPECT_EQ(held.error().attainable, plan->cycle_time());
  EXPECT_NE(held.error().message.find("1000 s (--hold-at-s)"), std::string::npos) << held.error().message;
  EXPECT_FALSE(insert_hold(limits, *plan, PlanOptions{}, {-1.0, 1.0}));
}

}  // namespace
}  // namespace toolpace
