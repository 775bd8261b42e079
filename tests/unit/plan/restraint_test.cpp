#include "toolpace/plan/restraint.h"

#include <gtest/gtest.h>

#include <numeric>

#include "plan_cases.h"
#include "toolpace/law/law_table.h"
#include "toolpace/plan/plan.h"

namespace toolpace {
namespace {

using test::symmetric;

std::vector<Restraint> explain(const SpeedLimits& limits, const PlanOptions& options) {
  const auto plan = plan_motion(limits, options);
  EXPECT_TRUE(plan);
  return explain(limits, *plan, node_times(limits, *plan), options);
}

std::vector<Cause> causes(const std::vector<Restraint>& restraints) {
  std::vector<Cause> list;
  for (const Restraint& r : restraints) list.push_back(r.cause);
  return list;
}

TEST(Restraints, CoverEveryPlanWithoutGaps) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const SpeedLimits limits = test::random_chain(seed, 80, seed % 2 == 0);
    for (const LawRow& law : law_table()) {
      PlanOptions options;
      options.law = law.kind;
      options.ramps = seed % 3 == 0 ? Ramps::block : Ramps::span;
      const auto plan = plan_motion(limits, options);
      const auto all = explain(limits, *plan, node_times(limits, *plan), options);
      ASSERT_FALSE(all.empty());
      EXPECT_EQ(all.front().begin, 0.0);
      EXPECT_EQ(all.back().end, plan->cycle_time());
      for (std::size_t i = 1; i < all.size(); ++i) {
        EXPECT_EQ(all[i].begin, all[i - 1].end);
        EXPECT_LE(all[i].begin, all[i].end);
        EXPECT_NE(all[i].cause, all[i - 1].cause);
      }
      const auto times = time_by_cause(all);
      EXPECT_NEAR(std::accumulate(times.begin(), times.end(), 0.0), plan->cycle_time(), 1e-9 * plan->cycle_time());
    }
  }
}

// Rest, S-ramp, feed, dip to a corner, feed of another block, S-ramp, rest.
TEST(Restraints, NameFeedCornerAccelerationAndJerkInTurn) {
  SpeedLimits limits = test::line_of({50, 50}, {50, 50}, symmetric(500, 1e4));
  limits.node_cap[1] = 10;
  limits.block_cause[1] = Cause::axis_speed;
  for (const Ramps ramps : {Ramps::block, Ramps::span}) {
    PlanOptions options;
    options.law = LawKind::seven_phase;
    options.ramps = ramps;
    using enum Cause;
    // 40 mm/s at J 1e4 takes √(40·1e4) = 632 > 500 mm/s²: the ramps hold their acceleration.
    EXPECT_EQ(causes(explain(limits, options)),
              (std::vector<Cause>{stop, acceleration, jerk, feed, jerk, acceleration, corner, acceleration, jerk,
                                  axis_speed, jerk, acceleration, stop}));
  }
}

TEST(Restraints, BlameAShortLookAhead) {
  const SpeedLimits limits =
      test::line_of(std::vector<double>(20, 1.0), std::vector<double>(20, 100.0), symmetric(500, 1e4));
  PlanOptions options;
  options.law = LawKind::seven_phase;
  options.lookahead = 3;
  EXPECT_GT(time_by_cause(explain(limits, options))[static_cast<std::size_t>(Cause::lookahead)], 0.0);
  options.lookahead.reset();
  EXPECT_EQ(time_by_cause(explain(limits, options))[static_cast<std::size_t>(Cause::lookahead)], 0.0);
}

TEST(Restraints, TellAxisFromPathAcceleration) {
  SpeedLimits limits = test::line_of({50}, {50}, symmetric(500, 1e4));
  limits.dynamics_cause = {Cause::axis_acceleration};
  PlanOptions options;
  options.law = LawKind::trapezoid;
  EXPECT_EQ(causes(explain(limits, options)),
            (std::vector<Cause>{Cause::axis_acceleration, Cause::feed, Cause::axis_acceleration}));
}

}  // namespace
}  // namespace toolpace
