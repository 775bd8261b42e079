/// The lower bound for motions through the tolerance tube.

#include "toolpace/bound/tube_bound.h"

#include <numbers>
#include <random>

#include "planned_program.h"
#include "toolpace/bound/lower_bound.h"
#include "toolpace/pipeline/job_rules.h"

namespace toolpace {
namespace {

using namespace testing;

std::shared_ptr<Job> bounded_job(const Program& program, double tolerance) {
  auto job = smoothed_job(program);
  job->options.corner.tolerance = tolerance;
  return job;
}

// A line of 100 mm at 100 mm/s and 2000 mm/s², without a tolerance: 1 s and half the time of each ramp of 0.05 s.
TEST(TubeBound, IsTheFastestMotionAlongALine) {
  Program program;
  program.line(100, 0);
  const auto job = bounded_job(program, 0.01);
  const Path path = build_path(program.moves(), 0.0).value();
  Machine machine = job->machine;
  machine.period = 1e-6;
  EXPECT_NEAR(tube_bound(path, command(path, *job), machine, 0.0), 1.05, 1e-6);
  EXPECT_NEAR(tube_bound(path, command(path, *job), machine, 0.5), 1.04, 1e-6);  // 99 mm are left
}

// 4 strokes of 10 mm between rests: each 10/100 + 0.05 s.
TEST(TubeBound, RestsWhereTheProgramPauses) {
  Program program;
  program.line(10, 0).dwell(1).line(0, 0).dwell(1).line(10, 0).dwell(0).line(0, 0);
  const auto job = bounded_job(program, 1e-6);
  const Path path = build_path(program.moves(), 0.0).value();
  EXPECT_NEAR(tube_bound(path, command(path, *job), job->machine, 0.0), 0.6, 0.6 * 1e-3);
}

// A circle of 20 mm radius at 50 mm/s.
TEST(TubeBound, FollowsCurves) {
  Program program;
  program.arc(0, 20, 2 * std::numbers::pi, 0, 50);
  const auto job = bounded_job(program, 1e-3);
  const Path path = build_path(program.moves(), 0.0).value();
  const double length = 2 * std::numbers::pi * 20;
  const double bound = tube_bound(path, command(path, *job), job->machine, 1e-3);
  EXPECT_LT(bound, length / 50 + 50.0 / 2000);
  EXPECT_GT(bound, 0.995 * length / 50);
}

// Whole jobs, whose motions cut corners that the programmed path would have to be slow at.
TEST(TubeBound, IsBelowEveryMotionThroughTheTube) {
  std::mt19937_64 engine(11);
  const auto uniform = [&](double from, double to) {
    return from + (to - from) * static_cast<double>(engine() >> 11) * 0x1p-53;
  };
  for (const double size : {0.1, 1.0, 10.0}) {
    for (const double tolerance : {0.005, 0.05}) {
      Program program;
      double x = 0, y = 0;
      for (int i = 0; i < 60; ++i) {
        program.line(x += uniform(0, size), y += uniform(-size, size) / 2, 0, i % 20 < 10 ? 60 : 90);
        if (i == 40) program.dwell(0.1);
      }
      const auto outcome = run(bounded_job(program, tolerance));
      ASSERT_TRUE(outcome) << outcome.error().message;
      const double bound = lower_bound(*outcome).value();
      EXPECT_LE(bound, outcome->summary.cycle_time) << size << " " << tolerance;
      EXPECT_GT(bound, 0.2 * outcome->summary.cycle_time) << size << " " << tolerance;
    }
  }
}

}  // namespace
}  // namespace toolpace
