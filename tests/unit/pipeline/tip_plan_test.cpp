#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "places.h"
#include "toolpace/bound/lower_bound.h"
#include "toolpace/limits/travel.h"
#include "toolpace/machine/setup.h"
#include "toolpace/nc/reader.h"
#include "toolpace/path/axis_curve.h"
#include "toolpace/pipeline/job.h"
#include "toolpace/pipeline/prove.h"
#include "toolpace/sample/motion.h"
#include "toolpace/sample/sampler.h"

namespace toolpace {
namespace {

toolpace::Setup machine_named(const std::string& name) {
  const auto text = read_settings_text(test::source_dir() / "resources/machines" / (name + ".toml"));
  return parse_setup(text.value(), name).value();
}

std::shared_ptr<const Reading> program_on(const toolpace::Setup& setup, const std::string& text,
                                          bool about_tip = false) {
  ReadOptions options;
  options.dialect = Dialect::fanuc;
  options.kinematics = setup.kinematics;
  options.travel = rotary_travel(setup.machine);
  options.about_tip = about_tip;
  auto reading = read_text(text, "t.nc", options).value();
  EXPECT_FALSE(reading.refused) << (reading.diagnostics.empty() ? "" : reading.diagnostics.front().message);
  return std::make_shared<const Reading>(std::move(reading));
}

Outcome planned(const toolpace::Setup& setup, const std::string& text, bool about_tip = false) {
  auto job = std::make_shared<Job>();
  job->program = program_on(setup, text, about_tip);
  job->machine = setup.machine;
  job->options = setup.options;
  auto outcome = run(job);
  EXPECT_TRUE(outcome) << outcome.error().message;
  return outcome.value();
}

bool warns(const Outcome& o, const std::string& code) {
  return std::any_of(o.warnings.begin(), o.warnings.end(), [&](const Diagnostic& d) { return d.code == code; });
}

double time_of(const Outcome& o, Cause cause) { return o.summary.time_by_cause[static_cast<std::size_t>(cause)]; }

TEST(TipPlan, TheFeedIsTheTipsAndNotTheAxes) {
  // The tip runs 20 mm at 10 mm/s, while the head swings a tool of 150 mm by 20 degrees.
  const Outcome o = planned(machine_named("five-axis"), "G90 G21 G94\nG43.4 H1\nG1 X20 B20 F600\nM30\n");
  EXPECT_NEAR(o.summary.peaks.speed, 10, 1e-9);
  EXPECT_NEAR(o.summary.cycle_time, 2.0, 0.05);
  EXPECT_TRUE(is_proven(o));
  Motion motion(*o.path, o.plan);
  const double x = motion.at(1.0).axes().speed[0];
  EXPECT_NEAR(x, 10 + 150 * 10 * kRadiansPerDegree * std::cos(10 * kRadiansPerDegree), 0.1)
      << "X makes up for the tool of 150 mm that swings back at 10 degrees a second, half way at 10 degrees";
}

TEST(TipPlan, ACurveThatTakesAllOfABlockEndsWhereTheAxesGoOn) {
  toolpace::Setup setup = machine_named("five-axis");
  setup.options.corner.rule = CornerRule::blend;
  setup.options.corner.tolerance = 0.2;
  const Outcome o =
      planned(setup, "G90 G21 G94\nG1 B20 F600\nG43.4 H1\nG1 X5 Y3 B30\nG1 X5.1 Y2.9\nG49\nG1 X0 Y0\nM30\n");
  const Path& path = *o.path;
  const AxisCurve curve(path);
  ASSERT_EQ(path.tellings.size(), 2u);
  EXPECT_EQ(path.kind[path.tellings[1].node - 1], SegmentKind::blend);
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    EXPECT_LT((curve.end_of(i) - curve.begin_of(i + 1)).norm(), 1e-9) << "behind segment " << i;
  EXPECT_TRUE(is_proven(o));
}

TEST(TipPlan, RotaryAxesAloneRunInDegreesAMinute) {
  const Outcome o = planned(machine_named("five-axis"), "G90 G21 G94\nG43.4 H1\nG1 B20 F600\nM30\n");
  EXPECT_NEAR(o.summary.rotary_peaks.speed, 10, 1e-9);
  EXPECT_EQ(o.summary.path_length, 0);
  Motion motion(*o.path, o.plan);
  for (const double t : {0.3, 1.0, 1.7})
    EXPECT_LT((motion.at(t).place() - motion.at(0).place()).head<3>().norm(), 1e-12);
}

TEST(TipPlan, SetpointsAreAxesAndGoOnWhereThePathIsToldAnew) {
  const Outcome o = planned(machine_named("five-axis"),
                            "G90 G21 G94\nG0 X30 B30 C40\nG43.4 H1\nG1 X20 Y5 F3000\nX0 C60\nG49\nG0 Z50\nM30\n");
  Sampler sampler(*o.path, o.plan, o.job->program->moves, 0.001);
  Setpoints rows;
  double largest = 0;
  while (sampler.next(rows)) {
    for (std::size_t i = 1; i < rows.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k)
        largest = std::max(largest, std::abs(rows.position[k][i] - rows.position[k][i - 1]));
    }
  }
  EXPECT_LT(largest, 0.5 * 1.01) << "no step beyond the machine's 500 mm/s";
  EXPECT_TRUE(is_proven(o));
}

TEST(TipPlan, ItsBladesAreProvenOnEachMachine) {
  auto rule = CornerRule::blend;
  for (const char* name : {"trunnion-ac", "trunnion-bc", "head-bc", "five-axis", "nutating-45"}) {
    rule = rule == CornerRule::blend ? CornerRule::servo : CornerRule::blend;
    toolpace::Setup setup = machine_named(name);
    const auto text =
        read_settings_text(test::source_dir() / "examples/nc" / (std::string("blade-") + name + ".nc")).value();
    setup.options.corner.rule = rule;
    const Outcome o = planned(setup, text);
    const auto report = prove(o);
    ASSERT_TRUE(report) << name;
    EXPECT_TRUE(report->passes()) << name;
    const auto tool = std::find_if(report->checks.begin(), report->checks.end(),
                                   [](const Check& c) { return c.kind == CheckKind::tool_angle; });
    ASSERT_NE(tool, report->checks.end());
    EXPECT_LT(tool->value, 0.011 * kRadiansPerDegree) << name << ": a degree counts as a millimetre";
    EXPECT_FALSE(warns(o, "travel")) << name;
    EXPECT_LE(lower_bound(o).value(), o.summary.cycle_time) << name;
  }
}

const Check& tool_angle(const VerifyReport& report) {
  return *std::find_if(report.checks.begin(), report.checks.end(),
                       [](const Check& c) { return c.kind == CheckKind::tool_angle; });
}

TEST(TipPlan, InAPlaneTheToolIsWhereVerificationHasItsOwnGreatCircle) {
  // Moving, standing, and on an arc; the middle of A −45 C 0 and A −45 C 90 is tilted by 35.2644 degrees instead of 45.
  const char* const text =
      "G90 G21 G94 G17\nG1 A-45 F3000\nG43.4 H1\nG1 X0 Y0\nX20 A-45 C90 F1200\nA-20 C30\nG3 X20 Y20 I0 J10 A-40 "
      "C80\nG1 X0 "
      "A-50 C75\nM30\n";
  toolpace::Setup setup = machine_named("trunnion-ac");
  setup.kinematics.chain.orientation = Orientation::plane;
  for (const CornerRule rule : {CornerRule::stop, CornerRule::blend}) {
    setup.options.corner.rule = rule;
    setup.options.ramps = rule == CornerRule::stop ? Ramps::block : Ramps::span;
    const Outcome o = planned(setup, text);
    EXPECT_FALSE(warns(o, "out-of-plane"));
    const auto report = prove(o);
    ASSERT_TRUE(report);
    for (const Check& c : report->checks)
      EXPECT_FALSE(c.broken) << check_title(c) << " " << c.value << " of " << c.limit;
    EXPECT_LT(tool_angle(*report).value, (rule == CornerRule::stop ? 2e-5 : 0.02) * kRadiansPerDegree);
    Motion motion(*o.path, o.plan);
    double least = 90;
    for (double t = 0; t < motion.duration(); t += 0.01) {
      const AxisVector place = motion.at(t).place();
      if (std::abs(place[0] - 10) < 0.3 && place[1] == 0) least = std::min(least, -place[3] / kRadiansPerDegree);
    }
    EXPECT_NEAR(least, 35.264, 0.01);
  }
}

TEST(TipPlan, WhatCannotTurnInAPlaneIsToldByItsLine) {
  toolpace::Setup setup = machine_named("trunnion-ac");
  setup.kinematics.chain.orientation = Orientation::plane;
  const Outcome o = planned(setup, "G90 G21 G94\nG43.4 H1\nG1 X20 A-30 C90 F1200\nX30 A-20 C80\nM30\n");
  ASSERT_TRUE(warns(o, "out-of-plane")) << "C has to turn where the tool is upright";
  const auto warning =
      std::find_if(o.warnings.begin(), o.warnings.end(), [](const Diagnostic& d) { return d.code == "out-of-plane"; });
  EXPECT_EQ(warning->where.line, 3u);
  EXPECT_TRUE(is_proven(o));
}

TEST(TipPlan, TheTubeIsRefusedWithAReason) {
  toolpace::Setup setup = machine_named("five-axis");
  setup.options.corner.rule = CornerRule::smooth;
  const Outcome o = planned(setup, "G90 G21 G94\nG43.4 H1\nG1 X20 B20 F600\nY20 C30\nM30\n");
  EXPECT_TRUE(warns(o, "smooth-fell-back"));
  EXPECT_EQ(o.ran.corner.rule, CornerRule::blend);
  EXPECT_EQ(o.job->options.corner.rule, CornerRule::smooth) << "what was asked";
}

TEST(TipPlan, NearThePoleTheCapSaysSo) {
  // Past the pole at 1 degree: C turns by 176 degrees within 0.4 mm of the tip's way, and again. It is 0.98 s at 360 deg/s.
  toolpace::Setup setup = machine_named("five-axis");
  setup.options.law = LawKind::seven_phase;
  setup.options.ramps = Ramps::span;
  const auto at_tilt = [&](const char* tilt) {
    return planned(
        setup, std::string("G90 G21 G94\nG43.4 H1\nG1 X10 ") + tilt + " C0 F3000\nX10.4 C176\nX10.8 C352\nX20\nM30\n");
  };
  EXPECT_GT(time_of(at_tilt("B1"), Cause::singularity), 0.5);
  EXPECT_EQ(time_of(at_tilt("B40"), Cause::singularity), 0);
}

TEST(TipPlan, TravelIsThatOfTheAxes) {
  // At B90 the tool of 150 mm lies along −X: the tip is at 300 mm, the axis at 450 of 350 mm.
  const Outcome o = planned(machine_named("five-axis"), "G90 G21 G94\nG43.4 H1\nG1 X300 B90 F6000\nM30\n");
  const auto excess = find_travel_excess(*o.path, o.job->machine);
  ASSERT_FALSE(excess.empty());
  EXPECT_EQ(o.job->program->moves.line[excess.front().row], 3u);
  EXPECT_TRUE(warns(o, "travel"));
  EXPECT_FALSE(warns(planned(machine_named("five-axis"), "G90 G21 G94\nG43.4 H1\nG1 X300 F6000\nM30\n"), "travel"));
}

TEST(TipPlan, WithoutTurnsItIsThePlanOfTheAxes) {
  const std::string body = "G1 X20 F3000\nG3 X30 Y10 R10\nG1 Y40\nX0\nM30\n";
  for (const CornerRule rule : {CornerRule::servo, CornerRule::stop, CornerRule::junction}) {
    toolpace::Setup setup = machine_named("five-axis");
    setup.options.corner.rule = rule;
    const Outcome tip = planned(setup, "G90 G21 G94\n" + body, true);
    const Outcome axes = planned(setup, "G90 G21 G94\n" + body);
    // The right angle between turning and changing speed is not made use of about the tip.
    EXPECT_NEAR(tip.summary.cycle_time, axes.summary.cycle_time, 0.01 * axes.summary.cycle_time);
    EXPECT_TRUE(is_proven(tip));
  }
}

}  // namespace
}  // namespace toolpace
