#include "toolpace/pipeline/strategy.h"

#include <numbers>

#include "planned_program.h"
#include "toolpace/law/law_table.h"
#include "toolpace/nc/reader.h"
#include "toolpace/pipeline/job_rules.h"

namespace toolpace {
namespace {

using namespace testing;

std::shared_ptr<Job> job_of(const Program& program, CornerRule rule, LawKind law) {
  auto job = std::make_shared<Job>();
  job->program = program.reading();
  const toolpace::Setup setup = axis_limited_setup();
  job->machine = setup.machine;
  job->options = setup.options;
  job->options.law = law;
  job->options.corner.rule = rule;
  return job;
}

Program crooked() {
  Program program;
  program.line(10, 0).line(20, 6).line(30, 0).arc(30, 5, std::numbers::pi / 2).line(35, 30);
  return program;
}

/// Another value of a setting.
void change(Setting setting, Job& job) {
  PlanOptions& o = job.options;
  switch (setting) {
    case Setting::law: o.law = o.law == LawKind::quintic ? LawKind::trapezoid : LawKind::quintic; break;
    case Setting::t_acc: o.t_acc *= 2; break;
    case Setting::t_dec: o.t_dec *= 2; break;
    case Setting::jerk: job.machine.path.jerk = job.machine.path.jerk_deceleration = 1e3; break;
    case Setting::lookahead: o.lookahead = o.lookahead == 1 ? 2 : 1; break;
    case Setting::ramps: o.ramps = o.ramps == Ramps::span ? Ramps::block : Ramps::span; break;
    case Setting::corner:
      o.corner.rule = o.corner.rule == CornerRule::stop ? CornerRule::servo : CornerRule::stop;
      break;
    case Setting::tolerance: o.corner.tolerance *= 3; break;
    case Setting::junction_deviation: o.corner.junction_deviation *= 3; break;
  }
}

void expect_same_motion(const Outcome& a, const Outcome& b, const std::string& where) {
  EXPECT_EQ(a.summary.cycle_time, b.summary.cycle_time) << where;
  ASSERT_EQ(a.plan.phases.size(), b.plan.phases.size()) << where;
  for (std::size_t i = 0; i < a.plan.phases.size(); ++i)
    EXPECT_EQ(a.plan.phases[i].begin, b.plan.phases[i].begin) << where;
}

// Every corner rule and law: what an outcome says it ignores may be set to anything.
TEST(Strategy, WhatIsIgnoredChangesNothing) {
  std::size_t ignored = 0;
  for (const CornerRule rule :
       {CornerRule::stop, CornerRule::servo, CornerRule::junction, CornerRule::blend, CornerRule::smooth}) {
    for (const LawRow& law : law_table()) {
      for (const bool steps : {false, true}) {
        const auto job = job_of(crooked(), rule, law.kind);
        if (steps) job->options.corner.step = 5;
        const auto outcome = run(job);
        if (!outcome) continue;
        for (std::size_t k = 0; k < kSettingCount; ++k) {
          const auto setting = static_cast<Setting>(k);
          if (!outcome->ignored.has(setting)) continue;
          ++ignored;
          auto other = std::make_shared<Job>(*job);
          change(setting, *other);
          const auto again = run(other);
          const std::string where = std::string(law.id) + " rule " + std::to_string(static_cast<int>(rule)) +
                                    " setting " + std::to_string(k) + (steps ? " step" : "");
          ASSERT_TRUE(again) << where << again.error().message;
          expect_same_motion(*outcome, *again, where);
        }
      }
    }
  }
  EXPECT_GT(ignored, 100u);
}

TEST(Strategy, AMotionThroughTheTubeSaysThatItTookNoLawAndNoWindow) {
  const auto job = job_of(crooked(), CornerRule::smooth, LawKind::trapezoid);
  job->options.lookahead = 1;
  const auto outcome = run(job);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->job->options.law, LawKind::trapezoid);
  EXPECT_EQ(outcome->ran.law, LawKind::time_optimal);
  EXPECT_FALSE(outcome->ran.lookahead);
  EXPECT_EQ(outcome->ran.ramps, Ramps::span);
  for (const Setting s : {Setting::law, Setting::lookahead, Setting::ramps}) EXPECT_TRUE(outcome->ignored.has(s));
}

// Blocks under G61 stay on the path, by the job's own law.
TEST(Strategy, ExactBlocksKeepTheLawOfTheJob) {
  Program program;
  program.line(10, 0).line(20, 6).control(PathControl::exact_stop).line(30, 0).line(40, 6);
  const auto job = job_of(program, CornerRule::smooth, LawKind::quintic);
  EXPECT_EQ(strategy_of(*job, program.moves().size()).id, "through-tube");
  const auto outcome = run(job);
  ASSERT_TRUE(outcome);
  // Motions through the tube and blends are compared; either keeps the law where the program asks for the exact path.
  if (outcome->ran.corner.rule == CornerRule::smooth) {
    EXPECT_EQ(outcome->ran.law, LawKind::quintic);
  }
}

TEST(Strategy, TheFirstRowThatTakesAJobRunsIt) {
  const auto smooth = job_of(crooked(), CornerRule::smooth, LawKind::seven_phase);
  const auto blend = job_of(crooked(), CornerRule::blend, LawKind::seven_phase);
  blend->options.ramps = Ramps::span;
  const auto servo = job_of(crooked(), CornerRule::servo, LawKind::quintic);
  const auto curves = job_of(crooked(), CornerRule::servo, LawKind::quintic);
  curves->options.ramps = Ramps::span;
  const auto lines = job_of(Program().line(10, 0).line(20, 6), CornerRule::servo, LawKind::quintic);
  lines->options.ramps = Ramps::span;
  EXPECT_EQ(strategy_of(*smooth, 5).id, "through-tube");
  EXPECT_EQ(strategy_of(*blend, 5).id, "quickly-through-tube");
  EXPECT_EQ(strategy_of(*blend, 5, false).id, "timed-anew");  // it has an arc
  const auto window = job_of(crooked(), CornerRule::blend, LawKind::seven_phase);
  window->options.ramps = Ramps::span;
  window->options.lookahead = 2;
  EXPECT_EQ(strategy_of(*window, 5).id, "along-path");
  EXPECT_EQ(strategy_of(*servo, 5).id, "along-path");
  EXPECT_EQ(strategy_of(*curves, 5).id, "timed-anew");
  EXPECT_EQ(strategy_of(*lines, 2).id, "along-path");
  EXPECT_TRUE(takes_long(*smooth));
  EXPECT_FALSE(takes_long(*servo));
  EXPECT_FALSE(takes_long(*quick_version(*smooth)));
}

// A spline is one block of the program and many segments of its path.
TEST(Strategy, ALookAheadOverAllBlocksIsTheSameAsAll) {
  auto reading = read_text(
      "G21 G90 G17 G64 P0.02\nG1 X10 Y2 F3000\nG5 I10 J30 P-20 Q20 X40 Y12\nG1 X50 Y0\nG1 X60 Y12\nM2\n", "spline.ngc");
  ASSERT_TRUE(reading && !reading->refused);
  const auto program = std::make_shared<const Reading>(std::move(*reading));
  const std::size_t blocks = motion_blocks(program->moves);
  for (const CornerRule rule : {CornerRule::servo, CornerRule::blend}) {
    const auto all = job_of(crooked(), rule, LawKind::seven_phase);
    all->program = program;
    all->options.ramps = Ramps::span;
    const auto far = run(all);
    ASSERT_TRUE(far);
    ASSERT_GT(far->path->size(), blocks);
    for (const std::size_t depth : {blocks, blocks + 1, far->path->size() - 1, far->path->size(), std::size_t{1000}}) {
      const auto deep = std::make_shared<Job>(*all);
      deep->options.lookahead = depth;
      const auto outcome = run(deep);
      ASSERT_TRUE(outcome);
      expect_same_motion(*outcome, *far, "look-ahead " + std::to_string(depth));
      EXPECT_EQ(outcome->job->options.lookahead, depth);
      EXPECT_FALSE(outcome->ran.lookahead);
    }
  }
}

}  // namespace
}  // namespace toolpace
