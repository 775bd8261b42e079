/// Arcs from rest to rest: what every law makes of them, measured on the setpoints.

#include <numbers>

#include "planned_program.h"
#include "toolpace/law/law_table.h"
#include "toolpace/limits/limit_speed.h"
#include "toolpace/pipeline/prove.h"
#include "toolpace/sample/motion.h"

namespace toolpace {
namespace {

using namespace testing;

Machine axes_of(double acceleration, double jerk) {
  Machine machine;
  machine.path = {400, acceleration, acceleration, jerk, jerk};
  for (std::size_t k = 0; k < 3; ++k) {
    machine.axes[k].speed = 400;
    machine.axes[k].acceleration = acceleration;
    machine.axes[k].jerk = jerk;
  }
  return machine;
}

Outcome plan_of(const Program& program, const Machine& machine, LawKind law, Ramps ramps) {
  toolpace::Setup setup = default_setup();
  setup.machine = machine;
  setup.options.law = law;
  setup.options.ramps = ramps;
  Outcome outcome = planned(program, setup);
  const auto report = prove(outcome);
  EXPECT_TRUE(report && report->passes()) << (report ? broken(*report) : report.error().message);
  return outcome;
}

Program half_circle(double radius, double feed) {
  Program program;
  program.arc(radius, 0, -std::numbers::pi, 0, feed);
  return program;
}

// One arc has no corner: a motion of 0.273 s is known for half a circle of 10 mm within 3000 mm/s² and 1e5 mm/s³ an axis,
// one of 0.849 s for a whole one of 20 mm within 1750 mm/s² and 3e4 mm/s³.
TEST(CurvePlan, EveryLawThatKeepsJerkIsNearTheFastestMotionOnAnArc) {
  Program whole;
  whole.arc(-20, 0, 2 * std::numbers::pi, 0, 200);
  for (const LawRow& law : law_table()) {
    if (!law.bounds_jerk) continue;
    SCOPED_TRACE(law.id);
    EXPECT_LE(plan_of(half_circle(10, 200), axes_of(3000, 1e5), law.kind, Ramps::span).summary.cycle_time, 0.277);
    EXPECT_LE(plan_of(half_circle(10, 200), axes_of(3000, 1e5), law.kind, Ramps::block).summary.cycle_time, 0.335);
    EXPECT_LE(plan_of(whole, axes_of(1750, 3e4), law.kind, Ramps::span).summary.cycle_time, 0.845);
    EXPECT_LE(plan_of(whole, axes_of(1750, 3e4), law.kind, Ramps::block).summary.cycle_time, 0.975);
  }
}

// Curves are timed anew without the caps that were chosen for their blocks; the corner rule holds all the same, also where it
// allows a little more than those caps.
TEST(CurvePlan, CornersBetweenArcsArePassedNoFasterThanTheirRuleAllows) {
  constexpr double kRadius = 2;
  int timed_anew = 0;
  for (double deflection = 0.02; deflection < 1.5; deflection *= 1.25) {
    // A quarter of a circle to (2, 2), leaving along +y; the next one leaves there at an angle, about a centre to its left.
    Program program;
    program.arc(0, kRadius, std::numbers::pi / 2);
    program.arc(kRadius - kRadius * std::cos(deflection), kRadius - kRadius * std::sin(deflection), 2.0);
    toolpace::Setup setup = default_setup();
    setup.machine = axes_of(1000, 3e4);
    setup.options.law = LawKind::seven_phase;
    setup.options.ramps = Ramps::span;
    setup.options.corner.rule = CornerRule::junction;
    const Outcome outcome = planned(program, setup);
    timed_anew += outcome.ran.law == LawKind::time_optimal;
    const double allowed = corner_speed(setup.options.corner, end_direction(*outcome.path, 0),
                                        start_direction(*outcome.path, 1), setup.machine);
    Motion motion(*outcome.path, outcome.plan);
    EXPECT_LE(motion.at(outcome.node_time[1]).along().speed, allowed * (1 + 1e-9)) << deflection;
    const auto report = prove(outcome);
    EXPECT_TRUE(report && report->passes()) << deflection << broken(*report);
  }
  EXPECT_GT(timed_anew, 0);
}

TEST(CurvePlan, AHigherFeedIsNeverSlowerOnAnArc) {
  for (const Ramps ramps : {Ramps::block, Ramps::span}) {
    for (const LawRow& law : law_table()) {
      if (!law.bounds_jerk && ramps == Ramps::span) continue;
      double last = 1e9;
      for (double feed = 10; feed < 400; feed *= 1.15) {
        const double time = plan_of(half_circle(5, feed), axes_of(3000, 1e5), law.kind, ramps).summary.cycle_time;
        EXPECT_LE(time, last * 1.001) << law.id << " feed " << feed;
        last = std::min(last, time);
      }
    }
  }
}

// Cut into pieces, an arc is the same arc.
TEST(CurvePlan, AnArcInPiecesIsAboutAsFastAsInOne) {
  for (const int pieces : {2, 4, 9}) {
    Program program;
    for (int i = 0; i < pieces; ++i) program.arc(10, 0, -std::numbers::pi / pieces, 0, 200);
    for (const LawKind law : {LawKind::quintic, LawKind::seven_phase}) {
      SCOPED_TRACE(pieces);
      EXPECT_LE(plan_of(program, axes_of(3000, 1e5), law, Ramps::span).summary.cycle_time, 0.28);
      EXPECT_LE(plan_of(program, axes_of(3000, 1e5), law, Ramps::block).summary.cycle_time, 0.45);
    }
  }
}

// Without limits of their own the axes take the path's: none accelerates by more than --am on a curve, or jerks by more.
TEST(CurvePlan, AxesWithoutLimitsTakeThoseOfThePath) {
  Machine machine;
  machine.path = {200, 1000, 1000, 3e4, 3e4};
  for (const Ramps ramps : {Ramps::block, Ramps::span}) {
    const Outcome outcome = plan_of(half_circle(10, 200), machine, LawKind::seven_phase, ramps);
    Machine judge = machine;
    for (std::size_t k = 0; k < 3; ++k) {
      judge.axes[k].acceleration = 1000;
      judge.axes[k].jerk = 3e4;
    }
    TemporaryDirectory directory;
    write_setpoints(outcome, directory / "arc.csv");
    const VerifyReport report = verified(directory / "arc.csv", judge);
    EXPECT_TRUE(report.passes()) << broken(report);
  }
}

// Without a jerk limit an axis' jerk does not count.
TEST(CurvePlan, ALawWithoutJerkIsNotHeldToTheAxesJerk) {
  const auto at = [](double jerk) {
    return plan_of(half_circle(2, 400), axes_of(3000, jerk), LawKind::trapezoid, Ramps::block).summary.cycle_time;
  };
  EXPECT_DOUBLE_EQ(at(1e3), at(1e9));
}

}  // namespace
}  // namespace toolpace
