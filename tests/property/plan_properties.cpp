/// Plans of random chains keep every limit on the exact polynomials, and the promises that plans make to each other.

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>

#include "case_count.h"
#include "plan_cases.h"
#include "plan_checker.h"
#include "toolpace/bound/path_bound.h"
#include "toolpace/law/law_table.h"
#include "toolpace/plan/plan.h"

namespace toolpace {
namespace {

std::string describe(const PlanOptions& o, std::uint64_t seed, bool mixed) {
  return std::string(law_row(o.law).id) + (o.ramps == Ramps::span ? " span" : " block") + " N " +
         std::to_string(o.lookahead.value_or(0)) + " seed " + std::to_string(seed) + (mixed ? " mixed" : "");
}

test::CheckOptions check_of(LawKind law) {
  const bool smooth = law_row(law).bounds_jerk;
  return {smooth, smooth, 1e-7};
}

struct Family {
  Ramps ramps;
  std::size_t blocks;    ///< a chain
  std::uint64_t chains;  ///< for each law
  bool mixed;            ///< limits that change from block to block
  bool reverses = false;
};

class PlansOfRandomChains : public ::testing::TestWithParam<Family> {};

TEST_P(PlansOfRandomChains, KeepEveryLimit) {
  const Family& f = GetParam();
  constexpr std::size_t kDepths[] = {0, 0, 1, 2, 3, 8, 40};
  for (std::uint64_t seed = 1; seed <= test::case_count(f.chains); ++seed) {
    SpeedLimits limits = test::random_chain(seed, f.blocks, f.mixed);
    if (f.reverses) limits = test::with_reversals(std::move(limits), seed);
    for (const LawRow& law : law_table()) {
      PlanOptions options;
      options.law = law.kind;
      options.ramps = f.ramps;
      const std::size_t depth = kDepths[seed % std::size(kDepths)];
      if (depth > 0) options.lookahead = depth;
      const auto plan = plan_motion(limits, options);
      ASSERT_TRUE(plan) << plan.error().message;
      ASSERT_EQ(test::find_offence(limits, *plan, check_of(law.kind)), "") << describe(options, seed, f.mixed);
      ASSERT_GE(plan->cycle_time(), path_bound(limits, law.kind)) << describe(options, seed, f.mixed);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Families, PlansOfRandomChains,
                         ::testing::Values(Family{Ramps::block, 500, 280, false}, Family{Ramps::block, 500, 70, true},
                                           Family{Ramps::span, 150, 210, false}, Family{Ramps::span, 100, 70, true},
                                           Family{Ramps::span, 3, 500, false}, Family{Ramps::span, 7, 300, true},
                                           Family{Ramps::span, 60, 300, false, true},
                                           Family{Ramps::span, 4, 500, false, true},
                                           Family{Ramps::span, 8, 300, true, true}));

// Turning back with acceleration is worth it, whatever lies between the turns.
TEST(PlansOfRandomChains, AreNeverSlowerForTurningBack) {
  for (std::uint64_t seed = 1; seed <= test::case_count(1000); ++seed) {
    const bool mixed = seed % 3 == 0;
    const SpeedLimits rests = test::random_chain(seed + 500000, 2 + seed % 30, mixed);
    const SpeedLimits turns = test::with_reversals(rests, seed);
    for (const LawKind law : {LawKind::seven_phase, LawKind::time_optimal}) {
      PlanOptions options;
      options.law = law;
      options.ramps = Ramps::span;
      EXPECT_LE(plan_motion(turns, options)->cycle_time(), plan_motion(rests, options)->cycle_time() * (1 + 1e-3))
          << describe(options, seed + 500000, mixed);
    }
  }
}

// Micro and huge blocks side by side, limits from crawling to violent, in units from µm to m: nothing depends on scale.
TEST(PlansOfRandomChains, KeepEveryLimitAtEveryScale) {
  for (std::uint64_t seed = 1; seed <= test::case_count(4000); ++seed) {
    const SpeedLimits limits = test::wild_chain(seed);
    for (const LawRow& law : law_table()) {
      PlanOptions options;
      options.law = law.kind;
      options.ramps = (seed + static_cast<std::uint64_t>(law.kind)) % 2 == 0 ? Ramps::span : Ramps::block;
      if (seed % 3 == 0) options.lookahead = 1 + seed % (limits.size() + 2);
      const auto plan = plan_motion(limits, options);
      ASSERT_TRUE(plan) << plan.error().message;
      test::CheckOptions check = check_of(law.kind);
      check.tolerance = 1e-6;
      ASSERT_EQ(test::find_offence(limits, *plan, check), "") << describe(options, seed, false);
      ASSERT_GE(plan->cycle_time(), path_bound(limits, law.kind)) << describe(options, seed, false);
    }
  }
}

TEST(PlansOfRandomChains, AreNeverSlowerAcrossBlocksThanWithinThem) {
  for (std::uint64_t seed = 1; seed <= test::case_count(60); ++seed) {
    const bool mixed = seed % 3 == 0;
    const SpeedLimits limits = test::random_chain(seed + 100000, 80, mixed);
    for (const LawRow& law : law_table()) {
      PlanOptions options;
      options.law = law.kind;
      if (seed % 2 == 0) options.lookahead = 1 + seed % 11;
      const double block = plan_motion(limits, options)->cycle_time();
      options.ramps = Ramps::span;
      EXPECT_LE(plan_motion(limits, options)->cycle_time(), block * 1.001) << describe(options, seed + 100000, mixed);
    }
  }
}

// Not usually but always: every depth from 1 to beyond the chain's length, every law, no tolerance beyond rounding.
/// `apart`: depths grow by this share of themselves, at least by one.
void expect_no_loss_by_depth(const SpeedLimits& limits, std::uint64_t seed, bool mixed, double apart = 0) {
  for (const LawRow& law : law_table()) {
    PlanOptions options;
    options.law = law.kind;
    options.ramps = Ramps::span;
    double last = 1e300;
    for (std::size_t depth = 1; depth <= limits.size() + 2;
         depth += 1 + static_cast<std::size_t>(apart * static_cast<double>(depth))) {
      options.lookahead = depth <= limits.size() + 1 ? std::optional(depth) : std::nullopt;
      const auto plan = plan_motion(limits, options);
      ASSERT_LE(plan->cycle_time(), last * (1 + 1e-13)) << describe(options, seed, mixed);
      test::CheckOptions check = check_of(law.kind);
      check.tolerance = 1e-6;
      ASSERT_EQ(test::find_offence(limits, *plan, check), "") << describe(options, seed, mixed);
      last = plan->cycle_time();
    }
  }
}

TEST(PlansOfRandomChains, AreNeverSlowerUnderADeeperLookAhead) {
  for (std::uint64_t seed = 1; seed <= test::case_count(60); ++seed) {
    const bool mixed = seed % 3 != 0;
    const SpeedLimits limits = test::random_chain(seed + 200000, 3 + seed % 14, mixed);
    expect_no_loss_by_depth(seed % 2 == 0 ? limits : test::with_reversals(limits, seed), seed + 200000, mixed);
  }
  for (std::uint64_t seed = 1; seed <= test::case_count(4); ++seed) {
    expect_no_loss_by_depth(test::random_chain(seed + 300000, 50, seed % 2 == 0), seed + 300000, seed % 2 == 0);
    // Longer ones are searched in another way.
    expect_no_loss_by_depth(test::random_chain(seed + 310000, 200, seed % 2 == 0), seed + 310000, seed % 2 == 0, 0.2);
  }
}

TEST(PlansOfRandomChains, AreNeverSlowerUnderADeeperLookAheadAtAnyScale) {
  for (std::uint64_t seed = 1; seed <= test::case_count(200); ++seed) {
    const SpeedLimits limits = test::wild_chain(seed + 400000);
    if (limits.size() <= 30) expect_no_loss_by_depth(limits, seed + 400000, false);
  }
}

// Same input, same bytes; and a plan under a monitor is the plan without one.
TEST(PlansOfRandomChains, AreTheSameToTheLastBit) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const SpeedLimits limits = test::random_chain(seed, 300, seed % 2 == 0);
    PlanOptions options;
    options.law = LawKind::time_optimal;
    options.ramps = Ramps::span;
    const auto a = plan_motion(limits, options);
    const auto b = plan_motion(SpeedLimits(limits), options, Monitor{{}, [](double) {}});
    ASSERT_EQ(a->phases.size(), b->phases.size());
    for (std::size_t i = 0; i < a->phases.size(); ++i) {
      EXPECT_EQ(a->phases[i].begin, b->phases[i].begin);
      EXPECT_EQ(a->phases[i].distance, b->phases[i].distance);
      EXPECT_EQ(a->phases[i].rate, b->phases[i].rate);
    }
  }
}

// A million blocks without a rest between them: positions stay exact, nothing adds up.
TEST(PlansOfRandomChains, StayExactOverAMillionBlocks) {
  SpeedLimits limits = test::random_chain(7, 1000000);
  for (std::size_t i = 1; i + 1 < limits.node_cap.size(); ++i) {
    if (limits.node_cap[i] == 0) limits.node_cap[i] = 0.1;
  }
  for (const Ramps ramps : {Ramps::block, Ramps::span}) {
    PlanOptions options;
    options.law = ramps == Ramps::block ? LawKind::quintic : LawKind::seven_phase;
    options.ramps = ramps;
    const auto plan = plan_motion(limits, options);
    ASSERT_TRUE(plan);
    EXPECT_EQ(test::find_offence(limits, *plan, {true, true, 1e-6}), "");
  }
}

}  // namespace
}  // namespace toolpace
