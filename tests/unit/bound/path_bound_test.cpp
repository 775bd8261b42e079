#include "toolpace/bound/path_bound.h"

#include <gtest/gtest.h>

#include <cmath>

#include "plan_cases.h"
#include "toolpace/bound/bound_valley.h"
#include "toolpace/law/law_table.h"
#include "toolpace/plan/plan.h"

namespace toolpace {
namespace {

using test::symmetric;

// oracle/bound.py (T_acc, exact without a jerk limit): 0.3331 s; 3.217 s; 9.424 s.
TEST(LowerBound, IsTheAccelerationLimitedOptimumWithoutJerk) {
  EXPECT_NEAR(path_bound(test::ning_blocks(symmetric(3000, 1e6)), LawKind::trapezoid), 0.3331, 5e-5);
  test::PolylineRules rules{symmetric(294.2, 3e4)};
  rules.corner_step = 1e9;
  SpeedLimits limits = test::limits_of(test::polyline("butterfly588"), rules);
  EXPECT_NEAR(path_bound(limits, LawKind::trapezoid), 3.217, 5e-4);
  rules.corner_step = 0.739;
  limits = test::limits_of(test::polyline("butterfly588"), rules);
  EXPECT_NEAR(path_bound(limits, LawKind::trapezoid), 9.424, 5e-4);
}

// By hand: from rest with a ≤ √(2Jv) the speed is Jt²/2; 10 mm up and down at J 1e4: 5 = Jt³/6 each way, t = ∛(30/1e4).
TEST(LowerBound, RisesWithFullJerkFromRest) {
  EXPECT_NEAR(path_bound(test::line_of({5, 5}, {1e4, 1e4}, symmetric(1e9, 1e4)), LawKind::quintic), 2 * std::cbrt(3e-3),
              1e-11);
}

// Above each of these no proof can go: feasible plans of 10.088 s and 10.349 s are known (oracle/bound.py), and without
// corner caps of 3.227 s and 3.249 s. Envelopes alone prove 9.436 s; 9.781 s and 9.612 s come from convex relaxation.
TEST(LowerBound, CountsTheValleysThatCapsThrow) {
  struct Figure {
    double step, jerk, at_least, feasible;
  };
  for (const Figure& f :
       {Figure{0.739, 1e6, 9.45, 9.459}, Figure{0.739, 3e4, 9.93, 10.088}, Figure{0.739, 1e4, 10.11, 10.349},
        Figure{1e9, 3e4, 3.226, 3.227}, Figure{1e9, 1e4, 3.245, 3.249}}) {
    test::PolylineRules rules{symmetric(294.2, f.jerk)};
    rules.corner_step = f.step;
    const SpeedLimits limits = test::limits_of(test::polyline("butterfly588"), rules);
    const double bound = path_bound(limits, LawKind::time_optimal);
    EXPECT_GE(bound, f.at_least) << f.step << " " << f.jerk;
    EXPECT_LE(bound, f.feasible) << f.step << " " << f.jerk;
  }
}

void expect_bound_below_plans(const SpeedLimits& limits, std::uint64_t seed) {
  for (const LawRow& law : law_table()) {
    const double bound = path_bound(limits, law.kind);
    EXPECT_GT(bound, 0.0);
    for (const Ramps ramps : {Ramps::block, Ramps::span}) {
      PlanOptions options;
      options.law = law.kind;
      options.ramps = ramps;
      if (seed % 5 == 0) options.lookahead = 3;
      EXPECT_LE(bound, plan_motion(limits, options)->cycle_time()) << law.id << " seed " << seed;
    }
  }
}

TEST(LowerBound, IsNeverAboveAnyPlan) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    expect_bound_below_plans(test::random_chain(seed, 60, seed % 2 == 0), seed);
    expect_bound_below_plans(test::wild_chain(seed), seed);
  }
}

// By hand: full jerk both ways from a cap crossed with no acceleration: 0.5·1 + 1e3·0.5³/6 = 0.5208 mm in 0.5 s each way; any
// other acceleration there helps one side less than it costs the other.
TEST(LowerBound, OfAValleyIsFullJerkBothWays) {
  const double way = 0.5 * 1 + 1e3 * 0.125 / 6;
  EXPECT_NEAR(detail::valley_time({1.0, way, way, 1e4, 1e4, 1e3}), 1.0, 1e-4);
  EXPECT_LE(detail::valley_time({1.0, way, way, 1e4, 1e4, 1e3}), 1.0 + 1e-14);
}

TEST(LowerBound, OfNothingIsZero) {
  EXPECT_EQ(path_bound(test::line_of({}, {}, symmetric(1, 1)), LawKind::quintic), 0.0);
}

}  // namespace
}  // namespace toolpace
