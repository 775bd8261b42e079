/// Figures of single laws, by hand.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "toolpace/law/law_table.h"

namespace toolpace {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

// 15/(8·3000)·Δ exceeds √(10·Δ/(√3·1e6)) only for Δ > 14.78 mm/s, so at 10 mm/s jerk decides.
TEST(Quintic, SmallSpeedChangesAreLimitedByJerk) {
  const RampLimits limits{3000, 1e6, 0};
  EXPECT_NEAR(Quintic::duration(10, limits), std::sqrt(10 * 10 / (std::sqrt(3.0) * 1e6)), 1e-17);
  EXPECT_NEAR(Quintic::duration(20, limits), 15.0 * 20 / (8 * 3000), 1e-17);
  EXPECT_LT(Quintic::peak_acceleration(14.78, limits), 3000);
  EXPECT_NEAR(Quintic::peak_acceleration(14.79, limits), 3000, 1e-9);
}

// √(20² + 16/15·3000·2) = √6800.
TEST(Quintic, LongRampsReachBySquares) {
  EXPECT_NEAR(Quintic::reach(20, 2, {3000, kInf, 0}), std::sqrt(6800.0), 1e-12);
}

TEST(Quintic, JerkIsZeroAtBothEndsAndInTheMiddle) {
  std::vector<Phase> phases;
  Quintic::append_ramp(10, 60, {3000, 1e6, 0}, phases);
  ASSERT_EQ(phases.size(), 1u);
  const double time = phases[0].duration;
  for (const double u : {0.0, 0.5, 1.0}) EXPECT_NEAR(evaluate(phases[0], u * time).jerk, 0.0, 1e-8);
}

TEST(Trapezoid, ReachIsTheTextbookSquareRoot) {
  EXPECT_DOUBLE_EQ(Trapezoid::reach(3, 2, {4, kInf, 0}), 5.0);  // √(9 + 2·4·2)
}

// A = 10, J = 5: A²/J = 20. Δ = 30: 30/10 + 10/5 = 5 s. Δ = 5: 2·√(5/5) = 2 s.
TEST(SevenPhase, ConstantAccelerationAppearsAboveASquaredOverJ) {
  const RampLimits limits{10, 5, 0};
  EXPECT_DOUBLE_EQ(SevenPhase::duration(30, limits), 5.0);
  EXPECT_DOUBLE_EQ(SevenPhase::duration(5, limits), 2.0);
  std::vector<Phase> phases;
  SevenPhase::append_ramp(0, 30, limits, phases);
  EXPECT_EQ(phases.size(), 3u);
  phases.clear();
  SevenPhase::append_ramp(0, 5, limits, phases);
  EXPECT_EQ(phases.size(), 2u);
}

TEST(SevenPhase, WithoutAJerkLimitItIsTheTrapezoid) {
  const RampLimits limits{10, kInf, 0};
  EXPECT_EQ(SevenPhase::duration(30, limits), Trapezoid::duration(30, limits));
  EXPECT_DOUBLE_EQ(SevenPhase::reach(3, 7, limits), Trapezoid::reach(3, 7, limits));
}

// 2·√(4/1) = 4 s needs a peak of 2; with A = 1 the ramp is stretched to 2·4/1 = 8 s.
TEST(FivePhaseJerk, TheAccelerationLimitStretchesTheRamp) {
  EXPECT_DOUBLE_EQ(FivePhaseJerk::duration(4, {kInf, 1, 0}), 4.0);
  EXPECT_DOUBLE_EQ(FivePhaseJerk::duration(4, {1, 1, 0}), 8.0);
  EXPECT_DOUBLE_EQ(FivePhaseJerk::peak_jerk(4, {1, 1, 0}), 0.25);
}

TEST(FivePhaseTime, EveryRampLastsTaccHoweverSmall) {
  EXPECT_DOUBLE_EQ(FivePhaseTime::duration(1e-9, {kInf, kInf, 35}), 35.0);
  EXPECT_DOUBLE_EQ(FivePhaseTime::duration(90, {kInf, kInf, 35}), 35.0);
  EXPECT_DOUBLE_EQ(FivePhaseTime::peak_acceleration(90, {kInf, kInf, 35}), 180.0 / 35);
}

// From 10 over 35 cycles even no change needs a length of 350, so 300 allows no ramp and 400 reaches 2·400/35 − 10.
TEST(FivePhaseTime, AShortLengthAllowsNoRampAtAll) {
  EXPECT_DOUBLE_EQ(FivePhaseTime::reach(10, 300, {kInf, kInf, 35}), 10.0);
  EXPECT_DOUBLE_EQ(FivePhaseTime::reach(10, 400, {kInf, kInf, 35}), 800.0 / 35 - 10);
}

TEST(LawTable, IdsAreFoundAndUnknownOnesAreNot) {
  for (const LawRow& row : law_table()) EXPECT_EQ(find_law(row.id), row.kind);
  EXPECT_FALSE(find_law("five-phase"));
  EXPECT_EQ(law_ids(), "trapezoid, five-phase-time, five-phase-jerk, seven-phase, quintic, time-optimal");
}

TEST(LawTable, VisitCallsWithTheTypeOfTheKind) {
  for (const LawRow& row : law_table()) {
    EXPECT_EQ(visit_law(row.kind, [](auto law) { return decltype(law)::kKind; }), row.kind);
  }
}

}  // namespace
}  // namespace toolpace
