#include "toolpace/tune/pareto.h"

#include <gtest/gtest.h>

#include "toolpace/tune/expected_gain.h"

namespace toolpace {
namespace {

TEST(ParetoFront, KeepsWhatNothingBeatsByRisingTimeAndTheFirstOfEqualOnes) {
  const std::vector<Objectives> points = {{3, 1, {}}, {1, 3, {}}, {2, 3, {}}, {2, 2, {}}, {1, 3, {}}, {4, 1, {}}};
  EXPECT_EQ(pareto_front(points), (std::vector<std::size_t>{1, 3, 0}));
}

TEST(ParetoFront, VibrationCountsOnlyWhereItIsKnownOfBoth) {
  EXPECT_TRUE(dominates({1, 1, {}}, {1, 2, 5.0}));
  EXPECT_FALSE(dominates({1, 1, 6.0}, {1, 2, 5.0}));
  EXPECT_TRUE(dominates({1, 1, 4.0}, {1, 1, 5.0}));
  EXPECT_FALSE(dominates({1, 1, {}}, {1, 1, {}}));
}

// By hand: below the line from (0, 10) to (10, 0) lies (2, 3) by 1 − 0.2 − 0.3, (5, 2) by 1 − 0.5 − 0.2.
TEST(Knee, LiesFarthestBelowTheLineBetweenBothEnds) {
  const std::vector<Objectives> front = {{0, 10, {}}, {2, 3, {}}, {5, 2, {}}, {10, 0, {}}};
  EXPECT_EQ(knee_of(front), 1u);
  EXPECT_EQ(knee_of(std::vector<Objectives>{{1, 1, {}}}), 0u);
}

TEST(Knee, OfAFrontWithVibrationLeavesOutWhatIsThereForThatAlone) {
  const std::vector<Objectives> front = {{0, 10, 9.0}, {1, 30, 1.0}, {2, 3, 9.0},
                                         {5, 2, 9.0},  {10, 0, 9.0}, {20, 40, 0.0}};
  EXPECT_EQ(knee_of(front), 2u);
}

TEST(FlawLimits, AreKeptByWhatIsNotKnown) {
  const FlawLimits limits = {2, 3};
  EXPECT_TRUE(limits.keeps({1, 2, 3.0}));
  EXPECT_TRUE(limits.keeps({1, 2, {}}));
  EXPECT_FALSE(limits.keeps({1, 2, 3.5}));
  EXPECT_FALSE(limits.keeps({1, 2.5, {}}));
}

// By hand: (1, 3) covers 3 × 1, (2, 1) two more rows of 2 × 2; (3, 2) is inside, (5, 0) outside.
TEST(Hypervolume, IsTheAreaUpToTheReference) {
  const std::vector<Objectives> points = {{3, 2, {}}, {2, 1, {}}, {1, 3, {}}, {5, 0, {}}};
  EXPECT_DOUBLE_EQ(hypervolume(points, {4, 4, {}}), 3 * 1 + 2 * 2);
}

TEST(ExpectedGain, OfACertainPointIsTheAreaThatItAdds) {
  LogFront front;
  front.add({3, 1});
  front.add({1, 3});
  front.add({2, 3.5});  // dominated
  ASSERT_EQ(front.points.size(), 2u);
  front.reference = {4, 4};
  const double sure = 1e-9;
  // (2, 2): between the errors 2 and 3, times 2 to 3 … 1 × 1; against (0, 0) all that is not covered yet.
  EXPECT_NEAR(front.expected_gain({2, sure}, {2, sure}), 1, 1e-8);
  EXPECT_NEAR(front.expected_gain({3.5, sure}, {2, sure}), 0, 1e-8);
  EXPECT_NEAR(front.expected_gain({0, sure}, {0, sure}), 16 - (3 * 1 + 1 * 2), 1e-8);
}

TEST(ExpectedGain, GrowsWithDoubt) {
  LogFront front;
  front.add({1, 1});
  front.reference = {4, 4};
  EXPECT_NEAR(front.expected_gain({2, 1e-9}, {2, 1e-9}), 0, 1e-12);
  EXPECT_GT(front.expected_gain({2, 1}, {2, 1}), front.expected_gain({2, 0.5}, {2, 0.5}));
}

// By hand: half of a normal distribution lies below its mean; the mean of what lies below is σ/√(2π).
TEST(ExpectedSaving, IsWhatLiesBelowTheFastestWithinTheLimit) {
  EXPECT_NEAR(expected_saving({5, 2}, probability_below(1, {1, 1}), 5), 0.5 * 2 * 0.3989422804014327, 1e-12);
  EXPECT_NEAR(expected_saving({5, 2}, probability_below(1, {1, 1}), std::numeric_limits<double>::infinity()), 0.5,
              1e-12);
}

TEST(Surrogate, KnowsWhatItWasToldAndDoubtsTheRest) {
  std::vector<Features> at;
  std::vector<double> values;
  const auto place = [](double x, double choice) {
    Features f = {};
    f[static_cast<std::size_t>(Knob::acceleration)] = x;
    f[static_cast<std::size_t>(Knob::law)] = choice;
    return f;
  };
  for (int i = 0; i <= 10; ++i) {
    const double x = 0.1 * i;
    at.push_back(place(x, 0));
    values.push_back(x * x);
  }
  const auto lengths = Surrogate::fit(at, values, Surrogate::first_lengths());
  Surrogate guessed(at, values, lengths, {place(0.5, 0), place(0.55, 0), place(0.55, 3)});
  EXPECT_NEAR(guessed.at_candidate(0).mean, 0.25, 1e-3);
  EXPECT_NEAR(guessed.at_candidate(1).mean, 0.3025, 5e-3);
  EXPECT_GT(guessed.at_candidate(2).deviation, 3 * guessed.at_candidate(1).deviation);
  const Guess before = guessed.at_candidate(2);
  guessed.believe(2);
  EXPECT_LT(guessed.at_candidate(2).deviation, before.deviation / 10);
  EXPECT_DOUBLE_EQ(guessed.at_candidate(2).mean, before.mean);
}

}  // namespace
}  // namespace toolpace
