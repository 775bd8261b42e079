#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "toolpace/machine/setup.h"
#include "toolpace/nc/reader.h"
#include "toolpace/pipeline/follow.h"
#include "toolpace/tune/tune.h"

namespace toolpace {
namespace {

/// A zigzag of short strokes and a diagonal at 6 m/min: corners, ramps and feed all matter.
std::shared_ptr<Job> zigzag() {
  auto job = std::make_shared<Job>();
  job->program = std::make_shared<const Reading>(
      *read_text("G21 G90 G94 F6000\nG1 X4\nG1 X5 Y2\nG1 X1 Y3\nG1 X0 Y6\nG1 X3 Y6.5\nG1 X9 Y6\nG1 X20 Y0\nM2\n",
                 "zigzag.ngc", {}));
  job->machine = default_setup().machine;
  return job;
}

TuneOptions plans(std::size_t count) {
  TuneOptions options;
  options.plans = count;
  return options;
}

TEST(Tune, PointsOfTheFrontAreWhatTheirJobsGiveAndNoneIsDominated) {
  const auto tuning = tune(zigzag(), plans(40));
  ASSERT_TRUE(tuning) << tuning.error().message;
  EXPECT_EQ(tuning->plans, 40u);
  ASSERT_GT(tuning->front.size(), 3u);
  for (const Tuned& point : tuning->front) {
    const auto outcome = run(point.job);
    ASSERT_TRUE(outcome);
    const auto followed = follow(*outcome);
    ASSERT_TRUE(followed);
    EXPECT_EQ(outcome->summary.cycle_time, point.objectives.cycle_time);
    EXPECT_EQ(followed->max_contour_error, point.objectives.contour);
    for (const Tuned& other : tuning->front) EXPECT_FALSE(dominates(other.objectives, point.objectives));
  }
  ASSERT_TRUE(tuning->best);
  EXPECT_LE(tuning->front[*tuning->best].objectives.contour, tuning->present.objectives.contour);
  EXPECT_LE(tuning->front[*tuning->best].objectives.cycle_time, tuning->present.objectives.cycle_time);
}

TEST(Tune, TheSameJobGivesTheSameFrontAgain) {
  const auto once = tune(zigzag(), plans(30)), again = tune(zigzag(), plans(30));
  ASSERT_TRUE(once && again);
  ASSERT_EQ(once->front.size(), again->front.size());
  for (std::size_t i = 0; i < once->front.size(); ++i) {
    EXPECT_EQ(once->front[i].objectives.cycle_time, again->front[i].objectives.cycle_time);
    EXPECT_EQ(once->front[i].objectives.contour, again->front[i].objectives.contour);
  }
}

TEST(Tune, LimitsOfMachineAndJobAreNeverRaised) {
  const auto job = zigzag();
  job->machine.path.deceleration = 2000;
  job->options.lookahead = 4;
  const TuningSpace space(job, kAllKnobs);
  for (std::size_t k = 0; k < kKnobCount; ++k) {
    const auto knob = static_cast<Knob>(k);
    for (std::size_t place = 0; place < space.places(knob); ++place) {
      Position p = space.home();
      p[k] = static_cast<std::uint16_t>(place);
      const auto tried = space.job_at(p);
      const PathLimits &path = tried->machine.path, &own = job->machine.path;
      EXPECT_LE(path.acceleration, own.acceleration);
      EXPECT_LE(path.deceleration, own.deceleration);
      EXPECT_LE(path.jerk, own.jerk);
      EXPECT_LE(path.jerk_deceleration, own.jerk_deceleration);
      EXPECT_LE(tried->options.corner.tolerance, job->options.corner.tolerance);
      EXPECT_LE(tried->options.corner.junction_deviation, job->options.corner.junction_deviation);
      ASSERT_TRUE(tried->options.lookahead);
      EXPECT_LE(*tried->options.lookahead, 4u);
      EXPECT_NE(tried->options.law, LawKind::trapezoid) << "it would not keep the jerk limit";
      EXPECT_TRUE(check_setup(tried->machine, tried->options));
    }
  }
}

TEST(Tune, APositionThatMakesNoDifferenceIsTheSameAsAnother) {
  const TuningSpace space(zigzag(), kAllKnobs);
  Position p = space.home();
  p[static_cast<std::size_t>(Knob::tolerance)] = 3;  // the servo rule rounds nothing
  p[static_cast<std::size_t>(Knob::ramp_time)] = 3;  // the quintic has no time of its own
  EXPECT_EQ(space.canonical(p), space.home());
  p[static_cast<std::size_t>(Knob::jerk)] = 3;
  EXPECT_NE(space.canonical(p), space.home());
}

TEST(Tune, AnUnlimitedAccelerationMayBeTurnedDownToWhatAxesHave) {
  const auto job = zigzag();
  job->machine.path.acceleration = job->machine.path.deceleration = kUnlimited;
  job->machine.axes[0].acceleration = 300;
  job->machine.axes[1].acceleration = 400;
  const std::array knobs = {Knob::acceleration};
  const TuningSpace space(job, knobs);
  EXPECT_FALSE(space.job_at(space.home())->machine.path.acceleration < kUnlimited);
  Position p = space.home();
  --p[static_cast<std::size_t>(Knob::acceleration)];
  EXPECT_DOUBLE_EQ(space.job_at(p)->machine.path.acceleration, 500) << "along the diagonal";
}

TEST(Tune, WhatIsNotToBeTurnedStays) {
  TuneOptions options = plans(24);
  options.turned = {Knob::acceleration};
  const auto tuning = tune(zigzag(), options);
  ASSERT_TRUE(tuning);
  for (const Tuned& point : tuning->front) {
    EXPECT_EQ(point.job->options.law, LawKind::quintic);
    EXPECT_EQ(point.job->machine.path.jerk, default_setup().machine.path.jerk);
  }
}

TEST(Tune, ALimitIsKeptWhereItCanBe) {
  const double now = tune(zigzag(), plans(1))->present.objectives.contour;
  TuneOptions options = plans(40);
  options.contour = now / 4;
  const auto tuning = tune(zigzag(), options);
  ASSERT_TRUE(tuning && tuning->best);
  EXPECT_LE(tuning->front[*tuning->best].objectives.contour, now / 4);
  options.contour = now * 1e-9;
  options.plans = 3;
  const auto none = tune(zigzag(), options);
  ASSERT_TRUE(none);
  EXPECT_FALSE(none->best);
}

// A full grid of three accelerations, three jerks, three laws, three corner rules: 81 plans with the job itself.
TEST(Tune, FindsMoreThanAGridOfAsManyPlans) {
  const auto job = zigzag();
  TuneOptions options = plans(81);
  options.turned = {Knob::law, Knob::corner, Knob::acceleration, Knob::jerk};
  const TuningSpace space(job, options.turned);
  std::vector<Position> grid;
  for (const int law : {1, 2, 3}) {
    for (const int corner : {1, 2, 3}) {
      for (const int acceleration : {31, 63, 95}) {
        for (const int jerk : {31, 63, 95}) {
          Position p = space.home();
          p[static_cast<std::size_t>(Knob::law)] = static_cast<std::uint16_t>(law);
          p[static_cast<std::size_t>(Knob::corner)] = static_cast<std::uint16_t>(corner);
          p[static_cast<std::size_t>(Knob::acceleration)] = static_cast<std::uint16_t>(acceleration);
          p[static_cast<std::size_t>(Knob::jerk)] = static_cast<std::uint16_t>(jerk);
          if (p != space.home()) grid.push_back(p);
        }
      }
    }
  }
  const auto by_grid = tune_by_list(space, grid, options), found = tune(job, options);
  ASSERT_TRUE(by_grid && found);
  const auto objectives = [](const TuneResult& t) {
    std::vector<Objectives> list;
    for (const Tuned& point : t.front) list.push_back(point.objectives);
    return list;
  };
  const Objectives reference = {
      4 * found->front.front().objectives.cycle_time, found->front.front().objectives.contour, {}};
  EXPECT_GT(hypervolume(objectives(*found), reference), hypervolume(objectives(*by_grid), reference));
}

TEST(Tune, EndsWhenItIsTold) {
  std::stop_source source;
  source.request_stop();
  const auto cancelled = tune(zigzag(), plans(20), {source.get_token(), {}});
  ASSERT_FALSE(cancelled);
  EXPECT_EQ(cancelled.error().kind, ErrorKind::cancelled);
  TuneOptions options = plans(200);
  options.is_over = [] { return true; };
  const auto brief = tune(zigzag(), options);
  ASSERT_TRUE(brief);
  EXPECT_EQ(brief->plans, 1u) << "the job as it is, always";
}

TEST(Tune, ReportsProgressThatNeverFalls) {
  double last = 0;
  const auto tuning = tune(zigzag(), plans(20), {{}, [&](double fraction) {
                                                   EXPECT_GE(fraction, last);
                                                   last = fraction;
                                                 }});
  ASSERT_TRUE(tuning);
  EXPECT_DOUBLE_EQ(last, 1);
}

TEST(Tune, AJobThatCannotBePlannedIsAnError) {
  const auto job = zigzag();
  job->machine.path = {};
  const auto tuning = tune(job, plans(20));
  ASSERT_FALSE(tuning);
  EXPECT_EQ(tuning.error().kind, ErrorKind::usage);
}

}  // namespace
}  // namespace toolpace
