#include <gtest/gtest.h>

#include <memory>

#include "places.h"
#include "toolpace/machine/setup.h"
#include "toolpace/nc/reader.h"
#include "toolpace/pipeline/job.h"

namespace toolpace {
namespace {

AxisVector at(double x, double y) {
  AxisVector p = AxisVector::Zero();
  p[0] = x;
  p[1] = y;
  return p;
}

/// Rows of moves, one call each.
class ProgramBuilder {
 public:
  ProgramBuilder& add(MoveKind kind, const AxisVector& end, double feed = 0, std::uint32_t detail = kNoDetail) {
    Moves& m = reading_->moves;
    m.kind.push_back(kind);
    m.line.push_back(static_cast<std::uint32_t>(m.size()));
    m.file.push_back(0);
    m.mode.push_back(0);
    m.detail.push_back(detail);
    m.end.push_back(end);
    m.feed.push_back(feed);
    return *this;
  }
  ProgramBuilder& dwell(double seconds) {
    Moves& m = reading_->moves;
    m.dwells.push_back(seconds);
    return add(MoveKind::dwell, m.end.empty() ? m.start : m.end.back(), 0,
               static_cast<std::uint32_t>(m.dwells.size() - 1));
  }
  Job job() const {
    Job job;
    job.program = reading_;
    job.machine = default_setup().machine;
    return job;
  }

 private:
  std::shared_ptr<Reading> reading_ = std::make_shared<Reading>();
};

Outcome planned(const Job& job) {
  auto outcome = run(std::make_shared<const Job>(job));
  EXPECT_TRUE(outcome) << outcome.error().message;
  return outcome.value_or(Outcome{});
}

TEST(Run, TimesOfFeedRapidAndDwellAddUpToTheCycleTime) {
  ProgramBuilder program;
  program.dwell(0.3)
      .add(MoveKind::rapid, at(50, 0))
      .dwell(0.5)
      .add(MoveKind::feed, at(80, 0), 40)
      .dwell(0.25)
      .dwell(0.125);
  const Outcome o = planned(program.job());
  const Summary& s = o.summary;
  EXPECT_NEAR(s.dwell_time, 1.175, 1e-12);
  EXPECT_NEAR(s.feed_time + s.rapid_time + s.dwell_time, s.cycle_time, 1e-9);
  EXPECT_GT(s.rapid_time, 0.5);
  EXPECT_GT(s.feed_time, 30.0 / 40);
  EXPECT_EQ(s.blocks, 2u);
  EXPECT_DOUBLE_EQ(s.path_length, 80);
  ASSERT_EQ(o.node_time.size(), 3u);
  EXPECT_NEAR(o.node_time[1], 0.3 + s.rapid_time, 1e-9);
}

TEST(Run, TimesByCauseAddUpToTheCycleTime) {
  ProgramBuilder program;
  program.add(MoveKind::rapid, at(50, 0))
      .dwell(0.5)
      .add(MoveKind::feed, at(80, 0), 40)
      .add(MoveKind::feed, at(80, 20), 40);
  Job job = program.job();
  const Summary s = planned(job).summary;
  double sum = 0;
  for (const double time : s.time_by_cause) sum += time;
  EXPECT_NEAR(sum, s.cycle_time, 1e-9);
  EXPECT_NEAR(s.time_by_cause[static_cast<std::size_t>(Cause::dwell)], 0.5, 1e-9);
}

// 90 degrees at 10 deg/s, then 1 mm at 1 mm/s: neither speed is of the other's kind.
TEST(Run, PeaksOfRotaryMovesAreTheirOwn) {
  ProgramBuilder program;
  AxisVector turned = at(0, 0);
  turned[3] = 90 * kRadiansPerDegree;
  AxisVector aside = turned;
  aside[0] = 1;
  program.add(MoveKind::feed, turned, 10 * kRadiansPerDegree).add(MoveKind::feed, aside, 1);
  const Summary s = planned(program.job()).summary;
  EXPECT_NEAR(s.rotary_peaks.speed, 10, 1e-9);
  EXPECT_NEAR(s.peaks.speed, 1, 1e-9);
  EXPECT_GT(s.rotary_peaks.jerk, 0);
}

TEST(Run, AFeedHoldAddsItsRestAndTheTimeOfStoppingAndStarting) {
  ProgramBuilder program;
  program.dwell(0.1).add(MoveKind::feed, at(80, 0), 40);
  Job job = program.job();
  const double without = planned(job).summary.cycle_time;
  job.options.hold_at = 1.0;
  const Outcome held = planned(job);
  EXPECT_GT(held.summary.cycle_time, without + 1.0);
  EXPECT_LT(held.summary.cycle_time, without + 1.2);
  EXPECT_NEAR(held.summary.dwell_time, 1.1, 1e-12);
  EXPECT_NEAR(held.summary.feed_time + held.summary.dwell_time, held.summary.cycle_time, 1e-9);
  EXPECT_EQ(held.node_time.back(), held.summary.cycle_time);
}

TEST(Run, AProgramWithoutMotionLastsAsLongAsItsDwells) {
  ProgramBuilder program;
  program.dwell(2.0);
  EXPECT_EQ(planned(program.job()).summary.cycle_time, 2.0);
}

TEST(Run, AnEmptyProgramTakesNoTime) {
  const Outcome o = planned(ProgramBuilder().job());
  EXPECT_EQ(o.summary.cycle_time, 0.0);
  EXPECT_TRUE(o.plan.phases.empty());
}

TEST(Run, LeavingTheTravelIsAWarningWithItsLine) {
  ProgramBuilder program;
  program.add(MoveKind::rapid, at(50, 0)).add(MoveKind::rapid, at(120, 0)).add(MoveKind::rapid, at(130, -1));
  Job job = program.job();
  job.machine.axes[0].travel_min = 0;
  job.machine.axes[0].travel_max = 100;
  job.machine.axes[1].travel_min = 0;
  job.machine.axes[1].travel_max = 100;
  const Outcome o = planned(job);
  ASSERT_EQ(o.warnings.size(), 2u);
  EXPECT_EQ(o.warnings[0].where.line, 2u);
  EXPECT_NE(o.warnings[0].message.find("30"), std::string::npos) << o.warnings[0].message;
  EXPECT_EQ(o.warnings[1].where.line, 3u);
}

TEST(Run, AnArcThatBulgesOutOfTheTravelIsSeenThoughItsEndsAreInside) {
  ProgramBuilder program;
  program.add(MoveKind::rapid, at(10, 50)).add(MoveKind::arc, at(10, 30), 50, 0);
  auto reading = std::make_shared<Reading>(*program.job().program);
  reading->moves.arcs.push_back({Eigen::Vector3d(10, 40, 0), Eigen::Vector3d::UnitZ(), 3.141592653589793});
  Job job = program.job();
  job.program = reading;
  job.machine.axes[0].travel_min = 5;
  job.machine.axes[0].travel_max = 100;
  job.machine.axes[1].travel_max = 100;
  const Outcome o = planned(job);
  ASSERT_EQ(o.warnings.size(), 1u);
  EXPECT_EQ(o.warnings[0].where.line, 2u) << "the arc, whose leftmost point is X0";
}

TEST(Run, LimitsThatMakeNoSenseAreRefused) {
  Job job = ProgramBuilder().add(MoveKind::feed, at(1, 0), 10).job();
  job.machine.path.acceleration = -5;
  const auto outcome = run(std::make_shared<const Job>(job));
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().kind, ErrorKind::usage);
}

TEST(Run, SameJobSameBytes) {
  ProgramBuilder program;
  for (int i = 1; i < 200; ++i) program.add(MoveKind::feed, at(i * 0.1, (i * i) % 7 * 0.01), 30);
  const Outcome a = planned(program.job()), b = planned(program.job());
  ASSERT_EQ(a.plan.phases.size(), b.plan.phases.size());
  for (std::size_t i = 0; i < a.plan.phases.size(); ++i) {
    EXPECT_EQ(a.plan.phases[i].begin, b.plan.phases[i].begin);
    EXPECT_EQ(a.plan.phases[i].rate, b.plan.phases[i].rate);
  }
}

TEST(Run, ProgressRisesToOne) {
  ProgramBuilder program;
  program.add(MoveKind::feed, at(1, 0), 10);
  double last = 0;
  Monitor monitor;
  monitor.progress = [&](double f) {
    EXPECT_GE(f, last);
    last = f;
  };
  ASSERT_TRUE(run(std::make_shared<const Job>(program.job()), monitor));
  EXPECT_EQ(last, 1.0);
}

TEST(Run, StopsWithinAStepOfWhereItIsCancelled) {
  ProgramBuilder program;
  for (int i = 1; i <= 300'000; ++i) program.add(MoveKind::feed, at(i * 0.1, i % 7 * 0.1), 30);
  const auto job = std::make_shared<const Job>(program.job());
  std::vector<double> steps;
  ASSERT_TRUE(run(job, Monitor{{}, [&](double f) { steps.push_back(f); }}));
  ASSERT_GT(steps.size(), 8u);
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
    std::stop_source source;
    std::size_t told = 0;
    const Monitor monitor{source.get_token(), [&](double) {
                            if (told++ == i) source.request_stop();
                          }};
    const auto outcome = run(job, monitor);
    ASSERT_FALSE(outcome) << "asked at " << steps[i];
    EXPECT_EQ(outcome.error().kind, ErrorKind::cancelled);
    EXPECT_LE(told, i + 2) << "asked at " << steps[i];
  }
}

// Ning et al. 2014 print 1048.5, 502.7 and 439.3 ms for N = 1, 2, 4 and "nearly unchanged" for 8, with corners that they
// do not print. These corners give all of them at once, under the paper's own limits and a period of 4 ms.
TEST(Run, TwentyBlocksWithCornersTakeThePapersTimesAtEachDepth) {
  auto reading = read_file(test::source_dir() / "tests/data/blocks20_corners_a.csv");
  ASSERT_TRUE(reading) << reading.error().message;
  Job job;
  job.program = std::make_shared<const Reading>(std::move(*reading));
  job.machine = default_setup().machine;
  job.machine.path = {100, 3000, 3000, 1e6, 1e6};
  job.machine.period = 0.004;
  job.options.law = LawKind::quintic;
  job.options.corner.rule = CornerRule::servo;
  for (const auto& [lookahead, milliseconds] :
       {std::pair{1, 1047.84}, std::pair{2, 502.70}, std::pair{4, 439.30}, std::pair{8, 438.93}}) {
    job.options.lookahead = lookahead;
    EXPECT_NEAR(1e3 * planned(job).summary.cycle_time, milliseconds, 0.01) << "N = " << lookahead;
  }
}

// By hand: (v0 + v1)/2·0.05 s must fit 0.5 mm, so that a block is entered or left with no more than 20 mm/s: 5 s, at a feed of
// 100 mm/s, for 100 mm. With 1 ms a ramp takes what acceleration and jerk need.
TEST(Run, WarnsWhereLeastDurationsOfRampsDoNotFitTheBlocks) {
  ProgramBuilder program;
  for (int i = 1; i <= 200; ++i) program.add(MoveKind::feed, at(0.5 * i, 0), 100);
  Job job = program.job();
  job.options.law = LawKind::five_phase_time;
  job.options.t_acc = job.options.t_dec = 0.05;
  const Outcome slow = planned(job);
  ASSERT_EQ(slow.warnings.size(), 1u);
  EXPECT_EQ(slow.warnings[0].code, "ramp-times");
  EXPECT_GT(slow.summary.cycle_time, 5.0);
  job.options.t_acc = job.options.t_dec = 0.001;
  EXPECT_TRUE(planned(job).warnings.empty());
  job.options.t_acc = job.options.t_dec = 0.05;
  job.options.law = LawKind::five_phase_jerk;
  EXPECT_TRUE(planned(job).warnings.empty());
}

}  // namespace
}  // namespace toolpace
