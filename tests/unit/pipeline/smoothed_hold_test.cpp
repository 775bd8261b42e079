/// Feed hold in motions through the tolerance tube.

#include "planned_program.h"
#include "toolpace/pipeline/prove.h"

namespace toolpace {
namespace {

using namespace testing;

Program curve() {
  Program program;
  for (int i = 1; i <= 60; ++i) program.line(i, 4 * std::sin(0.3 * i), 0.1 * i);
  return program;
}

/// Rows at rest between the first and the last one.
struct Rest {
  double begin = -1, duration = 0;
};
Rest rest_of(const Outcome& outcome) {
  Rest rest;
  const double period = outcome.job->machine.period;
  Sampler sampler(*outcome.path, outcome.plan, outcome.job->program->moves, period);
  for (Setpoints chunk; sampler.next(chunk);) {
    for (std::size_t k = 0; k < chunk.size(); ++k) {
      const std::size_t row = chunk.first_row + k;
      if (row == 0 || row + 1 == sampler.rows() || chunk.speed[k] != 0) continue;
      if (rest.begin < 0) rest.begin = static_cast<double>(row) * period;
      rest.duration += period;
    }
  }
  return rest;
}

// From 100 mm/s at 2000 mm/s² and 5e4 mm/s³ an axis stops in 50 + 40 ms; curves bend, so twice that is allowed.
TEST(SmoothedHold, StopsInsideTheTubeWithEveryLimitHeldAndGoesOn) {
  const Program program = curve();
  const auto job = smoothed_job(program);
  const double alone = run(job)->summary.cycle_time;
  for (const double share : {0.05, 0.3, 0.5, 0.77, 0.95}) {
    SCOPED_TRACE(share);
    const auto held = std::make_shared<Job>(*job);
    held->options.hold_at = share * alone;
    const auto outcome = run(held);
    ASSERT_TRUE(outcome) << outcome.error().message;
    const auto report = prove(*outcome);
    ASSERT_TRUE(report);
    EXPECT_TRUE(report->passes()) << broken(*report);
    const Rest rest = rest_of(*outcome);
    EXPECT_GE(rest.begin, share * alone);
    EXPECT_LE(rest.begin, share * alone + 0.18);
    EXPECT_NEAR(rest.duration, 1.0, 0.006);
    EXPECT_GT(outcome->summary.cycle_time, alone + 1.0);
    EXPECT_LT(outcome->summary.cycle_time, alone + 1.3);
    EXPECT_NEAR(outcome->summary.dwell_time, 1.0, 0.006);
    EXPECT_NEAR(outcome->node_time.back(), outcome->summary.cycle_time, 1e-9);
    EXPECT_TRUE(std::is_sorted(outcome->node_time.begin(), outcome->node_time.end()));
  }
}

TEST(SmoothedHold, MakesAPauseLongerAndHoldsBehindIt) {
  Program program = curve();
  program.dwell(0.5).line(70, 0, 6).line(80, 3, 6);
  const auto job = smoothed_job(program);
  const auto alone = run(job);
  const double before = alone->node_time[60];
  for (const double after : {0.2, 0.7}) {  // in the pause; in the motion behind it
    SCOPED_TRACE(after);
    const auto held = std::make_shared<Job>(*job);
    held->options.hold_at = before + after;
    const auto outcome = run(held);
    ASSERT_TRUE(outcome) << outcome.error().message;
    const auto report = prove(*outcome);
    ASSERT_TRUE(report);
    EXPECT_TRUE(report->passes()) << broken(*report);
    EXPECT_NEAR(outcome->summary.dwell_time, 1.5, 0.006);
    EXPECT_EQ(outcome->node_time[60], before);
  }
}

TEST(SmoothedHold, HoldsInExactBlocksToo) {
  Program program;
  program.line(20, 0).line(20, 20).control(PathControl::exact_path).line(40, 20).line(40, 40);
  const auto job = smoothed_job(program);
  const auto alone = run(job);
  const auto held = std::make_shared<Job>(*job);
  held->options.hold_at = alone->node_time[2] + 0.2;
  const auto outcome = run(held);
  ASSERT_TRUE(outcome) << outcome.error().message;
  const auto report = prove(*outcome);
  ASSERT_TRUE(report);
  EXPECT_TRUE(report->passes()) << broken(*report);
  EXPECT_NEAR(outcome->summary.dwell_time, 1.0, 0.006);
}

TEST(SmoothedHold, RefusesAHoldBehindTheEnd) {
  const auto job = smoothed_job(curve());
  job->options.hold_at = 100;
  const auto outcome = run(job);
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().code, "hold-after-end");
}

}  // namespace
}  // namespace toolpace
