/// Rows that are passed over have nothing to tell.

#include "toolpace/sample/uniform_rows.h"

#include "planned_program.h"
#include "toolpace/sample/axis_peaks.h"

namespace toolpace {
namespace {

using namespace testing;

TEST(UniformRows, LieInDwellsAndOnStraightBlocksAtOneSpeed) {
  Program program;
  program.line(30, 40, 0, 10).dwell(0.5).arc(30, 60, 3.0).line(0, 0, 5, 20).line(0.01, 0);
  const Outcome outcome = planned(program, axis_limited_setup());
  const double period = outcome.job->machine.period;
  const auto uniform = uniform_rows(*outcome.path, outcome.plan, period);
  ASSERT_EQ(uniform.size(), 3U);
  std::size_t passed_over = 0, before = 0;
  Sampler sampler(*outcome.path, outcome.plan, program.moves(), period);
  Setpoints all;
  ASSERT_TRUE(sampler.next(all, sampler.rows()));
  for (const auto& [first, end] : uniform) {
    ASSERT_TRUE(before < first && first < end && end < all.size());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto& p = all.position[axis];
      const double step = p[first] - p[first - 1];
      for (std::size_t row = first - 1; row <= end + 2; ++row) ASSERT_NEAR(p[row] - p[row - 1], step, 1e-12) << row;
    }
    passed_over += end - first;
    before = end;
  }
  EXPECT_GT(passed_over, all.size() / 2);
}

TEST(UniformRows, CostNoPeakWhenTheyArePassedOver) {
  Program program;
  program.line(30, 40, 0, 10).dwell(0.5).line(0, 0, 5, 20).line(7, 0, 0, 15);
  const Outcome outcome = planned(program, axis_limited_setup());
  const auto sampler = [&] {
    return Sampler(*outcome.path, outcome.plan, program.moves(), outcome.job->machine.period);
  };
  AxisPeakMeter every, some;
  Setpoints chunk;
  for (Sampler rows = sampler(); rows.next(chunk);) every.add(chunk);
  Sampler rows = sampler();
  std::size_t next = 0;
  for (const auto& [first, end] : uniform_rows(*outcome.path, outcome.plan, outcome.job->machine.period)) {
    rows.next(chunk, first - next);
    some.add(chunk);
    rows.seek(end);
    rows.next(chunk, 1);
    some.resume(chunk);
    next = end + 1;
  }
  while (rows.next(chunk)) some.add(chunk);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(some.peaks()[axis].speed, every.peaks()[axis].speed, 1e-9);
    EXPECT_NEAR(some.peaks()[axis].acceleration, every.peaks()[axis].acceleration, 1e-6);
    EXPECT_NEAR(some.peaks()[axis].jerk, every.peaks()[axis].jerk, 1e-2);
  }
}

}  // namespace
}  // namespace toolpace
