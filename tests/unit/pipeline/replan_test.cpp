#include "toolpace/pipeline/replan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "toolpace/machine/setup.h"
#include "toolpace/nc/reader.h"

namespace toolpace {
namespace {

std::shared_ptr<const Reading> program() {
  std::string text = "G21 G90 F3000\nG0 X5\nG4 P0.2\n";
  for (int i = 0; i < 20; ++i) {
    text += "G1 X" + std::to_string(30 * std::cos(i * 0.2)) + " Y" + std::to_string(20 * std::sin(i * 0.37)) + "\n";
  }
  text += "G2 X0 Y0 R60\nT1 M6\nG1 X40\nM2\n";
  auto reading = read_text(text, "replan.ngc");
  EXPECT_TRUE(reading);
  return std::make_shared<const Reading>(std::move(*reading));
}

Job job_of(std::shared_ptr<const Reading> reading) {
  Job job;
  job.program = std::move(reading);
  job.machine = default_setup().machine;
  job.options = default_setup().options;
  return job;
}

Outcome taken(Result<Outcome> outcome) {
  EXPECT_TRUE(outcome) << (outcome ? "" : outcome.error().message);
  return outcome.value_or(Outcome{});
}

/// Every number of both, compared as such.
void expect_same(const Outcome& a, const Outcome& b, const char* what) {
  ASSERT_EQ(a.plan.phases.size(), b.plan.phases.size()) << what;
  for (std::size_t i = 0; i < a.plan.phases.size(); ++i) {
    const Phase &p = a.plan.phases[i], &q = b.plan.phases[i];
    ASSERT_TRUE(p.begin == q.begin && p.duration == q.duration && p.distance == q.distance && p.speed == q.speed &&
                p.acceleration == q.acceleration && p.rate == q.rate && p.shape == q.shape)
        << what << ", phase " << i;
  }
  EXPECT_EQ(a.node_time, b.node_time) << what;
  EXPECT_EQ(a.limits.node_cap, b.limits.node_cap) << what;
  EXPECT_EQ(a.limits.block_cap, b.limits.block_cap) << what;
  EXPECT_EQ(a.path->length, b.path->length) << what;
  EXPECT_EQ(a.summary.time_by_cause, b.summary.time_by_cause) << what;
  EXPECT_EQ(a.summary.blends.corners, b.summary.blends.corners) << what;
  EXPECT_EQ(a.warnings.size(), b.warnings.size()) << what;
}

using Edit = std::function<void(Job&)>;

TEST(Replan, GivesWhatRunGivesAfterAnyEdit) {
  const std::pair<const char*, Edit> edits[] = {
      {"nothing", [](Job&) {}},
      {"law", [](Job& j) { j.options.law = LawKind::seven_phase; }},
      {"law with a time", [](Job& j) { j.options.law = LawKind::five_phase_time; }},
      {"ramps", [](Job& j) { j.options.ramps = Ramps::span; }},
      {"look-ahead", [](Job& j) { j.options.lookahead = 3; }},
      {"acceleration", [](Job& j) { j.machine.path.acceleration = 700; }},
      {"jerk", [](Job& j) { j.machine.path.jerk = 2e5; }},
      {"axis", [](Job& j) { j.machine.axes[1].acceleration = 300; }},
      {"travel", [](Job& j) { j.machine.axes[0].travel_max = 10; }},
      {"feed override", [](Job& j) { j.options.feed_override = 0.5; }},
      {"period", [](Job& j) { j.machine.period = 0.004; }},
      {"tool change", [](Job& j) { j.machine.tool_change = 3; }},
      {"corner step", [](Job& j) { j.options.corner.step = 20; }},
      {"corner rule", [](Job& j) { j.options.corner.rule = CornerRule::junction; }},
      {"blend", [](Job& j) { j.options.corner.rule = CornerRule::blend; }},
      {"hold", [](Job& j) { j.options.hold_at = 0.7; }},
  };
  const auto reading = program();
  for (std::size_t i = 0; i < std::size(edits); ++i) {
    const auto& [from_name, from] = edits[i];
    Job first = job_of(reading);
    from(first);
    const Outcome before = taken(run(std::make_shared<const Job>(first)));
    for (std::size_t k = i % 2; k < std::size(edits); k += 2) {  // every second pair, of each edit in either place
      const auto& [name, edit] = edits[k];
      Job next = first;
      edit(next);
      const auto job = std::make_shared<const Job>(next);
      const std::string what = std::string(from_name) + " then " + name;
      expect_same(taken(replan(job, before)), taken(run(job)), what.c_str());
      if (HasFatalFailure()) return;
    }
  }
}

TEST(Replan, KeepsThePathObjectWhereOnlyLimitsChange) {
  Job job = job_of(program());
  const Outcome before = taken(run(std::make_shared<const Job>(job)));
  job.machine.path.acceleration = 1234;
  EXPECT_EQ(taken(replan(std::make_shared<const Job>(job), before)).path, before.path);
  job.options.corner.rule = CornerRule::blend;
  EXPECT_NE(taken(replan(std::make_shared<const Job>(job), before)).path, before.path);
}

TEST(Replan, TakesNothingFromAnotherProgram) {
  const Outcome before = taken(run(std::make_shared<const Job>(job_of(program()))));
  const auto other = std::make_shared<const Job>(job_of(program()));
  const Outcome outcome = taken(replan(other, before));
  EXPECT_NE(outcome.path, before.path);
  expect_same(outcome, taken(run(other)), "another program");
}

TEST(Replan, RefusesWhatRunRefuses) {
  Job job = job_of(program());
  const Outcome before = taken(run(std::make_shared<const Job>(job)));
  job.machine.path.acceleration = -1;
  EXPECT_FALSE(replan(std::make_shared<const Job>(job), before));
  job.machine.path.acceleration = kUnlimited;
  job.machine.path.deceleration = kUnlimited;
  const auto unbounded = replan(std::make_shared<const Job>(job), before);
  ASSERT_FALSE(unbounded);
  EXPECT_EQ(unbounded.error().code, run(std::make_shared<const Job>(job)).error().code);
}

}  // namespace
}  // namespace toolpace
