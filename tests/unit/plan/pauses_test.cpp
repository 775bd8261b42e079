#include "toolpace/plan/pauses.h"

#include <gtest/gtest.h>

namespace toolpace {
namespace {

/// Two moves of 1 s over 10 mm each, with a rest between them (shape does not matter here).
MotionPlan two_moves() {
  MotionPlan plan;
  for (const std::uint32_t node : {0u, 1u}) {
    plan.phases.push_back({double(node), 0.5, 0, 0, 40, 0, PhaseShape::constant_jerk, node});
    plan.phases.push_back({node + 0.5, 0.5, 5, 20, -40, 0, PhaseShape::constant_jerk, node});
  }
  return plan;
}

TEST(InsertPauses, DwellsDelayWhatFollows) {
  const MotionPlan plan = insert_pauses(two_moves(), {{1, 0, 0.25}, {1, 1, 0.5}, {2, 2, 2.0}}, NodePositions({10, 10}));
  ASSERT_EQ(plan.phases.size(), 7u);
  EXPECT_EQ(plan.phases[2].begin, 1.0);
  EXPECT_EQ(plan.phases[2].duration, 0.25);
  EXPECT_EQ(plan.phases[2].node, 1u);
  EXPECT_EQ(plan.phases[2].distance, 0);
  EXPECT_EQ(plan.phases[3].begin, 1.25);
  EXPECT_EQ(plan.phases[4].begin, 1.75);
  EXPECT_EQ(plan.phases[6].begin, 2.75);
  EXPECT_EQ(plan.cycle_time(), 4.75);
}

TEST(InsertPauses, AProgramThatOnlyDwellsLastsAsLongAsItsDwells) {
  const MotionPlan plan = insert_pauses({}, {{0, 0, 1.5}, {0, 1, 0.5}}, NodePositions(std::vector<double>{}));
  EXPECT_EQ(plan.cycle_time(), 2.0);
}

TEST(InsertPauses, PausesWithoutDurationChangeNothing) {
  EXPECT_EQ(insert_pauses(two_moves(), {{1, 0, 0.0}}, NodePositions({10, 10})).phases.size(), 4u);
}

}  // namespace
}  // namespace toolpace
