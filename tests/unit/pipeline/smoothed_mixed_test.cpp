/// Programs that mix motion through the tolerance tube with exact blocks, pauses and rotary moves.

#include "planned_program.h"
#include "toolpace/limits/limit_speed.h"
#include "toolpace/pipeline/job_rules.h"
#include "toolpace/pipeline/prove.h"
#include "toolpace/plan/smooth/plan_smooth.h"

namespace toolpace {
namespace {

using namespace testing;

/// The motion through the tube alone: a whole job would take blends where they were faster.
SmoothPlan through_tube(const Job& job) {
  const Path path = build_path(job.program->moves, job.machine.tool_change).value();
  LimitOptions options;
  options.corner = job.options.corner;
  const Commands commands = command(path, job);
  const SpeedLimits limits = limit_speed(path, commands, job.machine, options).value();
  return plan_smooth(path, commands, job.machine, limits, job.options).value();
}

Program mixed() {
  Program program;
  program.line(20, 20).line(20, 40).control(PathControl::exact_stop).line(40, 40).line(50, 30);
  program.control(PathControl::blend).line(50, 20).arc(50, 10, -1.5).dwell(0.25).line(70, 10);
  return program.control(PathControl::exact_path).line(80, 10).control(PathControl::blend).line(80, 30);
}

TEST(SmoothedMixed, RunsFollowOneAnotherWithoutAWait) {
  const SmoothPlan plan = through_tube(*smoothed_job(mixed()));
  ASSERT_EQ(plan.plan.splines.size(), 4u);
  double end = 0;
  for (const Phase& phase : plan.plan.phases) {
    EXPECT_NEAR(phase.begin, end, 1e-9);
    end = phase.begin + phase.duration;
  }
  EXPECT_NEAR(plan.node_time.back(), end, 1e-9);
}

// From rest to rest 20 mm take 0.2 + 0.05 + 0.04 s, 10 mm half as much way; the steps of a tube's motion are 2 ms.
TEST(SmoothedMixed, AnExactBlockTakesTheTimeOfASingleMoveWhereverItStands) {
  Program program;
  program.line(20, 0).control(PathControl::exact_stop).line(40, 0).control(PathControl::blend).line(50, 0);
  const SmoothPlan plan = through_tube(*smoothed_job(program));
  EXPECT_NEAR(plan.node_time[1], 0.29, 0.004);
  EXPECT_NEAR(plan.node_time[2] - plan.node_time[1], 0.29, 1e-9);
  EXPECT_NEAR(plan.node_time[3] - plan.node_time[2], 0.19, 0.004);
}

TEST(SmoothedMixed, EveryLimitHoldsAndTheDwellCounts) {
  const auto outcome = run(smoothed_job(mixed()));
  ASSERT_TRUE(outcome) << outcome.error().message;
  const auto report = prove(*outcome);
  ASSERT_TRUE(report);
  EXPECT_TRUE(report->passes()) << broken(*report);
  EXPECT_NEAR(outcome->summary.dwell_time, 0.25, 1e-12);
  EXPECT_NEAR(outcome->plan.cycle_time(), through_tube(*smoothed_job(mixed())).plan.cycle_time() + 0.25, 0.02);
}

TEST(SmoothedMixed, AHoldLengthensThePlanByItsRestWhereverItFalls) {
  const auto job = smoothed_job(mixed());
  const double alone = through_tube(*job).plan.cycle_time();
  for (double at = 0.1; at < alone; at += 0.17) {
    const auto held = std::make_shared<Job>(*job);
    held->options.hold_at = at;
    const auto outcome = run(held);
    ASSERT_TRUE(outcome) << outcome.error().message;
    const auto report = prove(*outcome);
    ASSERT_TRUE(report);
    EXPECT_TRUE(report->passes()) << at << ": " << broken(*report);
    EXPECT_GE(outcome->plan.cycle_time(), alone + 0.25 + 0.99) << at;
    EXPECT_LE(outcome->plan.cycle_time(), alone + 0.25 + 1.0 + 0.25) << at;
  }
}

}  // namespace
}  // namespace toolpace
