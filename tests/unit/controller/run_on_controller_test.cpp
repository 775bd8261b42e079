#include "toolpace/pipeline/run_on_controller.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <string>

#include "sample_settings.h"
#include "toolpace/nc/reader.h"
#include "toolpace/sample/motion.h"

namespace toolpace {
namespace {

using namespace testing;

ControllerRun run_of(const char* settings, Controller controller, const std::string& program) {
  ReadOptions reading;
  reading.dialect = dialect_of(controller);
  ControllerRun run;
  run.program = std::make_shared<const Reading>(read_text(program, "p.nc", reading).value());
  run.program_name = "p.nc";
  run.text = scan_program(program);
  run.settings = parse_controller_settings(settings, "settings", controller).value();
  return run;
}

std::string random_program(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> step(-3, 3), feed(300, 5000);
  std::string text = "G21 G90 G17\nG1 F1200\n";
  double x = 0, y = 0;
  for (std::size_t i = 0; i < 60; ++i) {
    const double dx = step(random), dy = step(random);
    const std::string end = " X" + std::to_string(x += dx) + " Y" + std::to_string(y += dy);
    text += random() % 4 == 0 ? "G2" + end + " I" + std::to_string(dx / 2) + " J" + std::to_string(dy / 2)
                              : (random() % 4 == 0 ? "G0" : "G1") + end + " Z" + std::to_string(0.05 * step(random));
    text += " F" + std::to_string(feed(random)) + "\n";
    if (i % 20 == 19) text += "G4 P0.1\nM3 S1000\n";
  }
  return text + "M2\n";
}

class RunOnController : public ::testing::TestWithParam<std::pair<const char*, Controller>> {};

TEST_P(RunOnController, TakesThePredictedTimeOnTheProgramsOwnPath) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    ControllerRun run = run_of(GetParam().first, GetParam().second, random_program(seed));
    if (seed % 3 == 0) run.options.baud = 9600;
    const auto found = run_on_controller(run);
    ASSERT_TRUE(found) << found.error().message;
    const Outcome& o = found->outcome;
    const double time = found->prediction.cycle_time;
    EXPECT_NEAR(o.plan.cycle_time(), time, 1e-9 * time) << seed;
    ASSERT_EQ(o.node_time.size(), o.path->size() + 1);
    EXPECT_TRUE(std::is_sorted(o.node_time.begin(), o.node_time.end()));
    EXPECT_NEAR(std::accumulate(o.summary.time_by_cause.begin(), o.summary.time_by_cause.end(), 0.0), time, 1e-6);
    EXPECT_NEAR(o.summary.feed_time + o.summary.rapid_time + o.summary.dwell_time, time, 1e-6);
    Motion motion(*o.path, o.plan);
    for (std::size_t node = 0; node < o.node_time.size(); ++node) {
      const AxisVector there = motion.at(o.node_time[node]).position();
      EXPECT_LE((there - o.path->node[node]).norm(), 0.02) << "node " << node << ", seed " << seed;
    }
    for (std::size_t i = 0; i + 1 < o.plan.phases.size(); ++i) {
      EXPECT_NEAR(o.plan.phases[i].begin + o.plan.phases[i].duration, o.plan.phases[i + 1].begin, 1e-9);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Controllers, RunOnController,
                         ::testing::Values(std::pair(kGrbl, Controller::grbl), std::pair(kGrbl, Controller::grblhal),
                                           std::pair(kKlipper, Controller::klipper),
                                           std::pair(kMarlin, Controller::marlin)),
                         [](const auto& of) { return std::string(controller_name(of.param.second)); });

// grbl has no limit on arcs but that of their chords' corners: v² = a·$11/$12·r, 5 a here, so that v²/r may be 2500 mm/s² of 500.
TEST(RunOnControllerLimits, ArcsOfGrblTakeMultiplesOfTheAxesAcceleration) {
  const auto found =
      run_on_controller(run_of(kGrbl, Controller::grbl, "G21 G90 G17 G0 X0 Y0\nG1 X30 F6000\nG3 X30 Y0 I0 J2\nM2\n"));
  ASSERT_TRUE(found) << found.error().message;
  const auto worst = axes_over_limits(found->outcome);
  ASSERT_TRUE(worst);
  ASSERT_EQ(worst->size(), 2u);
  for (const AxisExcess& e : *worst) {
    EXPECT_EQ(e.of, AxisExcess::Of::acceleration);
    EXPECT_EQ(e.line, 3u);
    EXPECT_GT(e.value, 2.5 * e.limit);
    EXPECT_LT(e.value, 5.2 * e.limit);
  }
}

TEST(RunOnControllerLimits, AreKeptOnLines) {
  const auto found =
      run_on_controller(run_of(kGrbl, Controller::grbl, "G21 G90\nG1 X30 Y20 Z-2 F6000\nG0 X0 Y0 Z0\nM2\n"));
  ASSERT_TRUE(found);
  const auto worst = axes_over_limits(found->outcome);
  ASSERT_TRUE(worst);
  EXPECT_TRUE(worst->empty()) << worst->front().value << " of " << worst->front().limit;
}

TEST(RunOnControllerLimits, LinuxcncHasNoMotionAlongThePath) {
  const auto found =
      run_on_controller(run_of("[TRAJ]\nLINEAR_UNITS = mm\nMAX_LINEAR_VELOCITY = 200\n[AXIS_X]\n"
                               "MAX_VELOCITY = 100\nMAX_ACCELERATION = 1000\n",
                               Controller::linuxcnc, "G21 G1 X10 F600\nM2\n"));
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, "controller-blends");
}

}  // namespace
}  // namespace toolpace
