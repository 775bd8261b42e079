#include <gtest/gtest.h>

#include "case_count.h"
#include "frechet.h"
#include "planned_program.h"
#include "polylines.h"
#include "toolpace/bound/lower_bound.h"

namespace toolpace {
namespace {

constexpr double kTolerance = 0.01;

Setup rounding(CornerRule rule = CornerRule::blend) {
  Setup setup = testing::axis_limited_setup();
  setup.machine.path = {};
  setup.machine.path.speed = 100;
  setup.options.law = LawKind::seven_phase;
  setup.options.ramps = Ramps::span;
  setup.options.corner.rule = rule;
  setup.options.corner.tolerance = kTolerance;
  return setup;
}

/// Chords of 0.05 … 0.5 mm; from one to the next the heading turns by up to `turn` either way.
testing::Program chords(std::size_t count, double turn, unsigned seed) {
  std::mt19937 engine(seed);
  const auto random = [&engine] { return static_cast<double>(engine()) / 4294967296.0; };
  testing::Program program;
  program.start(0, 0);
  double x = 0, y = 0, z = 0, heading = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double length = 0.05 + 0.45 * random();
    heading += turn * (2 * random() - 1);
    x += length * std::cos(heading);
    y += length * std::sin(heading);
    z += 0.02 * length * (2 * random() - 1);
    program.line(x, y, z);
  }
  return program;
}

test::Points rows(const Outcome& outcome) {
  test::Points points;
  Sampler sampler(*outcome.path, outcome.plan, outcome.job->program->moves, outcome.job->machine.period);
  for (Setpoints chunk; sampler.next(chunk);) {
    for (std::size_t k = 0; k < chunk.size(); ++k) {
      points.push_back(Eigen::Vector3d(chunk.position[0][k], chunk.position[1][k], chunk.position[2][k]));
    }
  }
  return points;
}

/// Largest share of an axis' limits that the setpoints use, from differences.
double use_of_limits(const test::Points& p, const Machine& machine) {
  const double h = machine.period;
  double most = 0;
  for (std::size_t k = 3; k < p.size(); ++k) {
    const Eigen::VectorXd v = (p[k] - p[k - 1]) / h, a = (p[k] - 2 * p[k - 1] + p[k - 2]) / (h * h),
                          j = (p[k] - 3 * p[k - 1] + 3 * p[k - 2] - p[k - 3]) / (h * h * h);
    for (int i = 0; i < 3; ++i) {
      const AxisLimits& axis = machine.axes[static_cast<std::size_t>(i)];
      most =
          std::max({most, std::abs(v[i]) / axis.speed, std::abs(a[i]) / axis.acceleration, std::abs(j[i]) / axis.jerk});
    }
  }
  return most;
}

void expect_sound(const Outcome& outcome) {
  const Moves& moves = outcome.job->program->moves;
  const Machine& machine = outcome.job->machine;
  const test::Points run = rows(outcome);
  EXPECT_LE(use_of_limits(run, machine), 1.005);
  test::Points programmed = {moves.start.head<3>()};
  for (const AxisVector& end : moves.end) programmed.push_back(end.head<3>());
  // Between setpoints a chord may cut off √3·A·Ts²/8.
  const double chord = std::sqrt(3.0) * machine.axes[0].acceleration * machine.period * machine.period / 8;
  EXPECT_TRUE(test::frechet_within(run, programmed, kTolerance + chord));
}

TEST(RoundedPlan, KeepsTheLimitsOfEveryAxisAndTheToleranceOnAnyTurns) {
  for (const double turn : {0.01, 0.08, 0.3, 1.0, 2.0, 3.14}) {
    for (unsigned seed = 1; seed <= test::case_count(2); ++seed) {
      SCOPED_TRACE(::testing::Message() << "turn " << turn << " seed " << seed);
      expect_sound(testing::planned(chords(150, turn, seed), rounding()));
    }
  }
}

// The servo rule lets the speed step at corners, jerk aside; blends that hold it come close.
TEST(RoundedPlan, IsAboutAsFastAsTheServoRuleThatHoldsNoJerk) {
  for (const double turn : {0.08, 3.14}) {
    for (unsigned seed = 11; seed <= 10 + test::case_count(1); ++seed) {
      SCOPED_TRACE(::testing::Message() << "turn " << turn << " seed " << seed);
      const testing::Program program = chords(400, turn, seed);
      const double blend = testing::planned(program, rounding()).summary.cycle_time;
      const double servo = testing::planned(program, rounding(CornerRule::servo)).summary.cycle_time;
      EXPECT_LE(blend, 1.1 * servo);
    }
  }
}

TEST(RoundedPlan, KeepsTheLimitsOfAxesAndPathThroughArcs) {
  for (unsigned seed = 31; seed <= 30 + test::case_count(3); ++seed) {
    std::mt19937 engine(seed);
    const auto random = [&engine] { return static_cast<double>(engine()) / 4294967296.0; };
    testing::Program program;
    program.start(0, 0);
    double x = 0, y = 0, heading = 0;
    for (int i = 0; i < 40; ++i) {
      heading += 2 * random() - 1;
      const double length = 0.2 + 3 * random();
      x += length * std::cos(heading);
      y += length * std::sin(heading);
      program.line(x, y, 0, 20 + 80 * random());
      // About a centre beside the end of the line: tangential or nearly so.
      const double radius = 0.3 + random(), sweep = 0.5 + random(), aside = heading + 0.1 * random();
      const double cx = x - radius * std::sin(aside), cy = y + radius * std::cos(aside);
      program.arc(cx, cy, sweep, 0.1 * random(), 60);
      x = cx + radius * std::sin(aside + sweep);
      y = cy - radius * std::cos(aside + sweep);
      heading += sweep;
    }
    toolpace::Setup setup = rounding();
    setup.machine.path = {90, 1500, 1200, 4e4, 3e4};
    setup.machine.axes[1].acceleration = 800;
    const Outcome outcome = testing::planned(program, setup);
    SCOPED_TRACE(seed);
    EXPECT_LE(use_of_limits(rows(outcome), setup.machine), 1.005);
    EXPECT_LE(outcome.summary.peaks.acceleration, 1500 * 1.0001);
    EXPECT_LE(outcome.summary.peaks.jerk, 4e4 * 1.0001);
  }
}

// Within a tenth or so of the thorough search.
TEST(RoundedPlan, IsNotMuchSlowerThanTheBestThroughTheTube) {
  for (const double turn : {0.05, 0.3, 1.0, 3.14}) {
    for (unsigned seed = 51; seed <= 50 + test::case_count(1); ++seed) {
      SCOPED_TRACE(::testing::Message() << "turn " << turn << " seed " << seed);
      const testing::Program program = chords(100, turn, seed);
      const double blend = testing::planned(program, rounding()).summary.cycle_time;
      EXPECT_LE(blend, 1.2 * testing::planned(program, rounding(CornerRule::smooth)).summary.cycle_time);
    }
  }
}

// G64 P in the program and the job's own rule are one thing.
TEST(RoundedPlan, IsTheSameForBlendsOfTheProgram) {
  testing::Program program = chords(60, 0.3, 41);
  const double by_rule = testing::planned(program, rounding()).summary.cycle_time;
  auto reading = std::make_shared<Reading>(*program.reading());
  for (MoveMode& mode : reading->moves.modes) {
    mode.control = PathControl::blend;
    mode.tolerance = kTolerance;
  }
  auto job = std::make_shared<Job>();
  job->program = reading;
  const toolpace::Setup setup = rounding(CornerRule::servo);
  job->machine = setup.machine;
  job->options = setup.options;
  const auto outcome = run(job);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->summary.cycle_time, by_rule);
}

TEST(RoundedPlan, IsNoSlowerInATubeTwiceAsWide) {
  for (const double turn : {0.1, 1.0}) {
    for (unsigned seed = 61; seed <= 60 + test::case_count(2); ++seed) {
      const testing::Program program = chords(40, turn, seed);
      double before = kUnlimited;
      for (double tolerance = 0.005; tolerance < 0.1; tolerance *= 2) {
        toolpace::Setup setup = rounding();
        setup.options.corner.tolerance = tolerance;
        const double now = testing::planned(program, setup).summary.cycle_time;
        EXPECT_LE(now, 1.01 * before) << "turn " << turn << " seed " << seed << " tolerance " << tolerance;
        before = now;
      }
    }
  }
}

// A slow block of half a millimetre between long fast ones: its feed holds where it is, whatever the tolerance.
TEST(RoundedPlan, DoesNotSpreadTheFeedOfASlowBlock) {
  testing::Program program;
  program.line(20, 0).line(20.5, 0.2, 0, 5.0 / 3).line(40, 0).line(40.5, 0.1, 0, 5.0 / 3).line(60, 0);
  for (const double tolerance : {0.001, 0.01, 0.1, 0.3}) {
    toolpace::Setup setup = rounding();
    setup.options.corner.tolerance = tolerance;
    // 1.05 mm at 5/3 mm/s are 0.629 s, and three strokes of 20 mm from almost rest to almost rest are 0.29 s each.
    EXPECT_LE(testing::planned(program, setup).summary.cycle_time, 0.629 + 3 * 0.29 + 0.02) << tolerance;
  }
}

TEST(RoundedPlan, IsNoFasterThanItsBound) {
  for (unsigned seed = 21; seed <= 20 + test::case_count(2); ++seed) {
    auto job = std::make_shared<Job>();
    job->program = chords(100, 0.5, seed).reading();
    const toolpace::Setup setup = rounding();
    job->machine = setup.machine;
    job->options = setup.options;
    const auto outcome = run(job);
    ASSERT_TRUE(outcome);
    const double bound = lower_bound(*outcome).value();
    EXPECT_LE(bound, outcome->summary.cycle_time);
    EXPECT_GT(bound, 0.1 * outcome->summary.cycle_time);
  }
}

// The butterfly's limits are 294.2 and 3e4 an axis, its tolerance 0.005 mm.
TEST(RoundedPlan, ReachesTheFiguresOnKnownPaths) {
  struct Case {
    const char* path;
    double feed, acceleration, jerk, tolerance, most;
  };
  for (const Case& c :
       {Case{"circle", 100, 2000, 50000, 0.01, 5.10}, Case{"smooth", 100, 2000, 50000, 0.01, 22},
        Case{"random", 100, 2000, 50000, 0.01, 161}, Case{"butterfly588", 50, 294.2, 30000, 0.005, 5.45}}) {
    SCOPED_TRACE(c.path);
    const test::Polyline path = test::polyline(c.path);
    testing::Program program;
    program.start(path.points[0][0], path.points[0][1], path.points[0][2]);
    for (std::size_t i = 1; i < path.points.size(); ++i) {
      const auto& [x, y, z] = path.points[i];
      program.line(x, y, z, std::min(path.feed[i], c.feed));
    }
    toolpace::Setup setup = rounding();
    setup.options.corner.tolerance = c.tolerance;
    for (std::size_t a = 0; a < 3; ++a) {
      setup.machine.axes[a].acceleration = c.acceleration;
      setup.machine.axes[a].jerk = c.jerk;
    }
    const Outcome outcome = testing::planned(program, setup);
    EXPECT_LE(outcome.summary.cycle_time, c.most);
    EXPECT_LE(use_of_limits(rows(outcome), setup.machine), 1.005);
  }
}

}  // namespace
}  // namespace toolpace
