/// Jobs with --corner smooth as a whole: which plan they end with, how they stop, and that threads do not matter.

#include <algorithm>
#include <atomic>
#include <random>
#include <thread>

#include "planned_program.h"
#include "toolpace/limits/limit_speed.h"
#include "toolpace/pipeline/job_rules.h"
#include "toolpace/pipeline/many.h"
#include "toolpace/pipeline/prove.h"
#include "toolpace/plan/smooth/plan_smooth.h"

namespace toolpace {
namespace {

using namespace testing;

Program wander(int blocks) {
  std::mt19937_64 engine(7);
  const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  Program program;
  double x = 0, y = 0;
  for (int i = 0; i < blocks; ++i) program.line(x += 0.3 * uniform(), y += 0.2 * (uniform() - 0.5));
  return program;
}

// At 2 mm/s nothing but the feed decides: curves that end exactly where they should are as fast as anything, 22 mm in 11 s.
TEST(SmoothedRun, IsNeverSlowerThanProvenBlends) {
  Program slow;
  for (int i = 1; i <= 10; ++i) slow.line(2 * i, i % 2, 0, 2);
  for (const Program& program : {slow, wander(300)}) {
    const auto smooth = smoothed_job(program), blend = std::make_shared<Job>(*smooth);
    blend->options.corner.rule = CornerRule::blend;
    const auto outcome = run(smooth);
    ASSERT_TRUE(outcome) << outcome.error().message;
    EXPECT_LE(outcome->summary.cycle_time, run(blend)->summary.cycle_time);
    EXPECT_EQ(outcome->job, smooth);
    const auto report = prove(*outcome);
    ASSERT_TRUE(report);
    EXPECT_TRUE(report->passes()) << broken(*report);
  }
}

TEST(SmoothedRun, BlendsWhereNothingBoundsAnAxisAndSaysSo) {
  Program program;
  program.line(10, 10).line(20, 5).line(30, 15);  // X bounds every block
  const auto job = smoothed_job(program);
  job->machine.path.acceleration = job->machine.path.deceleration = kUnlimited;
  job->machine.path.jerk = job->machine.path.jerk_deceleration = kUnlimited;
  job->machine.axes[1].acceleration = job->machine.axes[1].jerk = kUnlimited;
  const auto blend = std::make_shared<Job>(*job);
  blend->options.corner.rule = CornerRule::blend;
  const auto outcome = run(job), alone = run(blend);
  ASSERT_TRUE(alone) << alone.error().message;
  ASSERT_TRUE(outcome) << outcome.error().message;
  EXPECT_EQ(outcome->summary.cycle_time, alone->summary.cycle_time);
  ASSERT_FALSE(outcome->warnings.empty());
  EXPECT_EQ(outcome->warnings.back().code, "smooth-fell-back");
}

// The tube is held at places of each step, and after a dwell of 7 ms the setpoints at 4 ms fall between them.
TEST(SmoothedRun, PassesEveryCheckBehindDwellsOfBrokenPeriods) {
  constexpr int kPrograms = 30;
  int fallen_back = 0;
  for (unsigned seed = 1; seed <= kPrograms; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> step(-1.0, 1.0);
    Program program;
    double at[3] = {0, 0, 0};
    for (int i = 0; i < 9; ++i) {
      for (double& x : at) x += step(random);
      program.line(at[0], at[1], at[2]);
      if (i == 2) program.dwell(0.007);
    }
    const auto job = smoothed_job(program);
    job->machine.period = 0.004;
    job->options.corner.tolerance = 0.007;
    const auto outcome = run(job);
    ASSERT_TRUE(outcome) << outcome.error().message << ", seed " << seed;
    const auto report = prove(*outcome);
    ASSERT_TRUE(report);
    EXPECT_TRUE(report->passes()) << broken(*report) << "seed " << seed;
    const auto& all = outcome->warnings;
    const auto why = std::find_if(all.begin(), all.end(), [](const auto& w) { return w.code == "smooth-fell-back"; });
    if (why == all.end()) continue;
    ++fallen_back;
    EXPECT_GT(why->where.line, 0u);
    EXPECT_NE(why->message.find(" s instead of "), std::string::npos) << why->message;
  }
  EXPECT_GT(fallen_back, 0);          // else these programs test nothing
  EXPECT_LT(fallen_back, kPrograms);  // most of them pass through the tube
}

// Each thread may be about to finish something when it is asked. How long that takes is measured by scripts/bench.
TEST(SmoothedRun, ReportsProgressAndStopsWhereItIsWhenItIsCancelled) {
  const auto job = smoothed_job(wander(6000));
  std::stop_source source;
  std::atomic<double> last = 0;
  std::atomic<unsigned> later = 0;
  const Monitor monitor{source.get_token(), [&](double f) {
                          EXPECT_GE(f, last.load());
                          last = f;
                          if (source.stop_requested()) ++later;
                          if (f >= 0.3) source.request_stop();
                        }};
  const auto outcome = run(job, monitor);
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().kind, ErrorKind::cancelled);
  EXPECT_GE(last, 0.3);
  EXPECT_LE(later, std::thread::hardware_concurrency());
  EXPECT_LT(last, 1.0);
}

TEST(SmoothedRun, PlansTheSameBytesOnOneThreadAndOnTwo) {
  const auto job = smoothed_job(wander(1200));
  const Path path = build_path(job->program->moves, 0).value();
  LimitOptions options;
  options.corner = job->options.corner;
  const Commands commands = command(path, *job);
  const SpeedLimits limits = limit_speed(path, commands, job->machine, options).value();
  std::vector<SmoothPlan> plans;
  for (const std::size_t threads : {1, 2, 2}) {
    const ForEach for_each = [&](std::size_t count, const std::function<void(std::size_t)>& task) {
      (void)for_many<char>(count, threads, {}, [&](std::size_t i, const Monitor&) -> Result<char> {
        task(i);
        return '\0';
      });
    };
    plans.push_back(plan_smooth(path, commands, job->machine, limits, job->options, for_each).value());
  }
  EXPECT_GT(plans[0].windows, 2u);
  for (const SmoothPlan& plan : plans) {
    ASSERT_EQ(plan.plan.splines.size(), plans[0].plan.splines.size());
    for (std::size_t i = 0; i < plan.plan.splines.size(); ++i) {
      EXPECT_EQ(plan.plan.splines[i].control, plans[0].plan.splines[i].control);
    }
    EXPECT_EQ(plan.node_time, plans[0].node_time);
  }
}

double time_under(const Outcome& outcome, Cause cause) {
  return outcome.summary.time_by_cause[static_cast<std::size_t>(cause)];
}

// 40 mm at 20 mm/s take 2 s, and starting and stopping a tenth of one; corners of 0.3 mm sides leave jerk at its limit.
TEST(SmoothedRun, SaysWhichLimitBindsAtEachMoment) {
  Program program;
  program.line(0, 40, 0, 20);
  for (int i = 1; i <= 100; ++i) program.line(0.3 * ((i + 1) / 2), 40 + 0.3 * (i / 2));
  const auto job = smoothed_job(program);
  job->options.hold_at = 1.0;
  const auto outcome = run(job);
  ASSERT_TRUE(outcome) << outcome.error().message;
  ASSERT_FALSE(outcome->plan.splines.empty());
  double end = 0, sum = 0;
  for (const Restraint& r : outcome->restraints) {
    EXPECT_NEAR(r.begin, end, 1e-9);
    EXPECT_GT(r.end, r.begin);
    end = r.end;
  }
  EXPECT_NEAR(end, outcome->summary.cycle_time, 1e-9);
  for (const double time : outcome->summary.time_by_cause) sum += time;
  EXPECT_NEAR(sum, outcome->summary.cycle_time, 1e-9);
  EXPECT_NEAR(time_under(*outcome, Cause::dwell), 1.0, 0.01);
  EXPECT_NEAR(time_under(*outcome, Cause::feed), 1.9, 0.15);
  EXPECT_GT(time_under(*outcome, Cause::jerk), 0.8 * (sum - 3.0));
}

}  // namespace
}  // namespace toolpace
