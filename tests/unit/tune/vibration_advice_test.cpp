/// Advice against what is known of ramps and modes, and against planning with it.

#include "toolpace/tune/vibration_advice.h"

#include <gtest/gtest.h>

#include <cmath>

#include "toolpace/machine/setup.h"
#include "toolpace/nc/reader.h"
#include "toolpace/pipeline/sampled.h"
#include "toolpace/servo/vibration.h"

namespace toolpace {
namespace {

std::array<ServoAxis, kAxisCount> with_modes(std::vector<AxisMode> modes) {
  std::array<ServoAxis, kAxisCount> servo;
  servo[0].modes = std::move(modes);
  return servo;
}

std::shared_ptr<const Job> shaking_job() {
  auto job = std::make_shared<Job>();
  job->program =
      std::make_shared<const Reading>(read_text("G21 G90 G94\nG1 X30 F6000\nG4 P0.3\nG1 X5\nM2\n", "a.ngc").value());
  const toolpace::Setup setup = default_setup();
  job->machine = setup.machine;
  job->options = setup.options;
  job->machine.servo = with_modes({{23, 0.02, 1}});
  return job;
}

// The spectrum of a triangle of width T, sinc²(ωT/4), vanishes at T = 2k/f; of a rise of the acceleration in T, sinc(ωT/2), at k/f.
TEST(VibrationAdvice, CalmTimesAreWholePeriodsWithoutDamping) {
  const auto servo = with_modes({{20, 1e-9, 1}});
  const auto triangles = calm_times(CalmBy::five_phase, servo, 1e-3),
             rises = calm_times(CalmBy::seven_phase, servo, 1e-3);
  ASSERT_GE(triangles.size(), 3u);
  ASSERT_GE(rises.size(), 5u);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(triangles[k], 2 * (static_cast<double>(k) + 1) / 20, 1e-5);
  for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(rises[k], (static_cast<double>(k) + 1) / 20, 1e-5);
}

TEST(VibrationAdvice, DampingMovesThem) {
  const double calm = calm_times(CalmBy::five_phase, with_modes({{20, 0.1, 1}}), 1e-3).front();
  EXPECT_NE(calm, 0.1);
  EXPECT_NEAR(calm, 0.1 / std::sqrt(1 - 0.01), 0.01);
}

TEST(VibrationAdvice, IsWhatPlanningWithItGives) {
  const auto job = shaking_job();
  const auto advice = advise_on_vibration(job, 1e-3);
  ASSERT_TRUE(advice) << advice.error().message;
  ASSERT_EQ(advice->choices.size(), 8u);  // three laws and five shapers
  ASSERT_TRUE(advice->best);
  for (const CalmChoice& c : advice->choices) {
    const auto outcome = run(c.job);
    ASSERT_TRUE(outcome);
    const auto shaken =
        vibration(*outcome->path, outcome->plan, outcome->node_time, c.job->machine.servo, impulses_of(*outcome));
    EXPECT_EQ(largest_residual(*shaken), c.residual);
    EXPECT_EQ(setpoints_duration(*outcome), c.cycle_time);
    EXPECT_LE(c.job->machine.path.jerk, job->machine.path.jerk);
    const bool keeps = c.residual <= 1e-3;
    EXPECT_TRUE(!keeps || advice->choices[*advice->best].cycle_time <= c.cycle_time);
  }
  EXPECT_GT(advice->present.residual, 0.01);
  EXPECT_LE(advice->choices[*advice->best].residual, 1e-3);
}

TEST(VibrationAdvice, NeedsAMode) {
  auto job = std::make_shared<Job>(*shaking_job());
  job->machine.servo = {};
  EXPECT_EQ(advise_on_vibration(job, {}).error().code, "tune-no-resonance");
}

}  // namespace
}  // namespace toolpace
