#include "toolpace/bound/lower_bound.h"

#include <numbers>
#include <random>

#include "case_count.h"
#include "planned_program.h"
#include "toolpace/law/law_table.h"
#include "toolpace/pipeline/job_rules.h"

namespace toolpace {
namespace {

using namespace testing;

double uniform(std::mt19937_64& engine, double from, double to) {
  return from + (to - from) * static_cast<double>(engine() >> 11) * 0x1p-53;
}

/// Lines and arcs that mostly go on in one direction, with rests and corners between them.
Program random_program(std::mt19937_64& engine) {
  Program program;
  double x = 0, y = 0, heading = 0;
  const double feed = uniform(engine, 20, 200);
  for (int i = 0; i < 12; ++i) {
    const double size = uniform(engine, 0.5, 8);
    if (engine() % 4 == 0) heading += uniform(engine, -3, 3);
    if (engine() % 8 == 0) program.dwell(0.05);
    if (engine() % 2 == 0) {
      program.line(x += size * std::cos(heading), y += size * std::sin(heading), 0, feed);
      continue;
    }
    const double sweep = uniform(engine, 0.2, 5), side = engine() % 2 == 0 ? 1 : -1;
    const double cx = x - side * size * std::sin(heading), cy = y + side * size * std::cos(heading);
    program.arc(cx, cy, side * sweep, engine() % 4 == 0 ? 1 : 0, feed);
    heading += side * sweep;
    x = cx + side * size * std::sin(heading);
    y = cy - side * size * std::cos(heading);
  }
  return program;
}

Machine random_machine(std::mt19937_64& engine) {
  Machine machine;
  machine.path = {uniform(engine, 50, 300), uniform(engine, 500, 4000), uniform(engine, 500, 4000),
                  uniform(engine, 2e4, 2e5), uniform(engine, 2e4, 2e5)};
  for (std::size_t k = 0; k < 3; ++k) {
    machine.axes[k].speed = uniform(engine, 50, 300);
    machine.axes[k].acceleration = uniform(engine, 500, 4000);
    machine.axes[k].jerk = uniform(engine, 2e4, 2e5);
  }
  return machine;
}

// Every way of planning with a jerk limit: whichever of them made the outcome, none of the others is faster than its bound.
TEST(LowerBound, IsNeverAboveThePlanOfAnyStrategy) {
  std::mt19937_64 engine(5);
  for (std::uint64_t n = 0; n < test::case_count(4); ++n) {
    auto job = std::make_shared<Job>();
    job->program = random_program(engine).reading();
    job->machine = random_machine(engine);
    const CornerRule rules[] = {CornerRule::stop, CornerRule::servo, CornerRule::junction, CornerRule::blend};
    job->options.corner.rule = rules[n % 4];
    std::vector<double> times, bounds;
    for (const LawRow& law : law_table()) {
      if (!law.bounds_jerk) continue;
      for (const Ramps ramps : {Ramps::block, Ramps::span}) {
        auto one = std::make_shared<Job>(*job);
        one->options.law = law.kind;
        one->options.ramps = ramps;
        const auto outcome = run(one);
        if (!outcome) continue;  // a law that does not do these ramps says so
        times.push_back(outcome->summary.cycle_time);
        bounds.push_back(lower_bound(*outcome).value());
      }
    }
    ASSERT_GE(times.size(), 4u);
    const double fastest = *std::min_element(times.begin(), times.end());
    for (const double bound : bounds) {
      EXPECT_LE(bound, fastest * (1 + 1e-9)) << n;
      EXPECT_GT(bound, 0.2 * fastest) << n;
    }
  }
}

// Half a circle of 10 mm radius from rest to rest: a motion of 0.273 s is known that keeps every axis within these limits.
TEST(LowerBound, OfAnArcIsBelowAMotionThatIsKnown) {
  auto job = std::make_shared<Job>();
  Program program;
  program.arc(10, 0, -std::numbers::pi, 0, 200);
  job->program = program.reading();
  for (std::size_t k = 0; k < 3; ++k) {
    job->machine.axes[k].speed = 400;
    job->machine.axes[k].acceleration = 3000;
    job->machine.axes[k].jerk = 1e5;
  }
  job->machine.path = {400, 3000, 3000, 1e5, 1e5};
  const auto outcome = run(job);
  ASSERT_TRUE(outcome);
  const double bound = lower_bound(*outcome).value();
  EXPECT_LE(bound, 0.2721);
  EXPECT_GT(bound, 0.97 * 0.2721);
}

// An arc in one and more pieces: the fastest plan is near the bound, whatever the law of the outcome that is asked. (Timing
// anew keeps the smaller one of the path's limits for speeding up and slowing down, so here they are the same.)
TEST(LowerBound, IsNearTheFastestPlanOnArcs) {
  std::mt19937_64 engine(7);
  for (int n = 0; n < 12; ++n) {
    auto job = std::make_shared<Job>();
    Program program;
    const double radius = uniform(engine, 0.5, 30), feed = uniform(engine, 40, 400);
    const int arcs = 1 + n % 3;
    for (int k = 0; k < arcs; ++k) program.arc(-radius, 0, uniform(engine, 0.8, 6) / arcs, 0, feed);
    job->program = program.reading();
    job->machine = random_machine(engine);
    PathLimits& along = job->machine.path;
    along.deceleration = along.acceleration;
    along.jerk_deceleration = along.jerk;
    job->options.ramps = Ramps::span;
    job->options.law = LawKind::seven_phase;
    const auto fast = run(job);
    auto slow_job = std::make_shared<Job>(*job);
    slow_job->options.ramps = Ramps::block;
    slow_job->options.law = LawKind::quintic;
    const auto slow = run(slow_job);
    ASSERT_TRUE(fast && slow);
    for (const Outcome& outcome : {*fast, *slow}) {
      const double bound = lower_bound(outcome).value();
      EXPECT_LE(bound, fast->summary.cycle_time) << n;
      EXPECT_GE(bound, 0.97 * fast->summary.cycle_time) << n;
    }
  }
}

// On lines the limits are exact, and nothing is opened.
TEST(LowerBound, OfLinesIsThatOfTheirLimits) {
  auto job = std::make_shared<Job>();
  Program program;
  program.line(20, 0).line(20, 30).dwell(0.5).line(0, 0);
  job->program = program.reading();
  job->machine.path = {100, 2000, 2000, 5e4, 5e4};
  const auto outcome = run(job);
  ASSERT_TRUE(outcome);
  const SpeedLimits open = open_limits(*outcome);
  EXPECT_EQ(open.block_cap, outcome->limits.block_cap);
  EXPECT_EQ(open.node_cap, outcome->limits.node_cap);
  EXPECT_GT(lower_bound(*outcome).value(), 0.8 * outcome->summary.cycle_time);
}

}  // namespace
}  // namespace toolpace
