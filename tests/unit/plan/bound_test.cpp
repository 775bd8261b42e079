#include "toolpace/plan/bound.h"

#include <gtest/gtest.h>

#include <cmath>

#include "plan_cases.h"
#include "toolpace/law/law_table.h"
#include "toolpace/plan/plan.h"

namespace toolpace {
namespace {

using test::symmetric;

// oracle/bound.py (T_acc, exact without a jerk limit): 0.3331 s; 3.217 s; 9.424 s.
TEST(LowerBound, IsTheAccelerationLimitedOptimumWithoutJerk) {
  EXPECT_NEAR(lower_bound(test::ning_blocks(symmetric(3000, 1e6)), LawKind::trapezoid), 0.3331, 5e-5);
  test::PolylineRules rules{symmetric(294.2, 3e4)};
  rules.corner_step = 1e9;
  auto limits = test::read_polyline("curves/butterfly588.csv", rules);
  if (!limits) GTEST_SKIP() << "no shared curves here";
  EXPECT_NEAR(lower_bound(*limits, LawKind::trapezoid), 3.217, 5e-4);
  rules.corner_step = 0.739;
  limits = test::read_polyline("curves/butterfly588.csv", rules);
  EXPECT_NEAR(lower_bound(*limits, LawKind::trapezoid), 9.424, 5e-4);
}

// By hand: from rest with a ≤ √(2Jv) the speed is Jt²/2; 10 mm up and down at J 1e4: 5 = Jt³/6 each way, t = ∛(30/1e4).
TEST(LowerBound, RisesWithFullJerkFromRest) {
  EXPECT_NEAR(lower_bound(test::line_of({5, 5}, {1e4, 1e4}, symmetric(1e9, 1e4)), LawKind::quintic),
              2 * std::cbrt(3e-3), 1e-11);
}

TEST(LowerBound, IsNeverAboveAnyPlan) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const SpeedLimits limits = test::random_chain(seed, 60, seed % 2 == 0);
    for (const LawRow& law : law_table()) {
      const double bound = lower_bound(limits, law.kind);
      EXPECT_GT(bound, 0.0);
      for (const Ramps ramps : {Ramps::block, Ramps::span}) {
        PlanOptions options;
        options.law = law.kind;
        options.ramps = ramps;
        EXPECT_LE(bound, plan_motion(limits, options)->cycle_time()) << law.id << " seed " << seed;
      }
    }
  }
}

TEST(LowerBound, OfNothingIsZero) {
  EXPECT_EQ(lower_bound(test::line_of({}, {}, symmetric(1, 1)), LawKind::quintic), 0.0);
}

}  // namespace
}  // namespace toolpace
