/// Step pulses of whole programs against the exact motion.

#include "toolpace/sample/program_pulses.h"

#include "planned_program.h"
#include "toolpace/sample/motion.h"

namespace toolpace {
namespace {

using namespace testing;

Setup stepper_setup() {
  toolpace::Setup setup = axis_limited_setup();
  setup.machine.axes[0].steps_per_unit = 400;
  setup.machine.axes[1].steps_per_unit = 320.5;
  setup.machine.axes[2].steps_per_unit = 800;
  return setup;
}

std::vector<Pulse> pulses_of(const Outcome& outcome, double timer_hz, PulseCounts* counts = nullptr) {
  std::vector<Pulse> all;
  const TimedMotion motion{*outcome.path, outcome.plan, outcome.node_time};
  const auto result =
      program_pulses(motion, outcome.job->machine, timer_hz, [&](const std::vector<Pulse>& p) -> Result<void> {
        all.insert(all.end(), p.begin(), p.end());
        return {};
      });
  EXPECT_TRUE(result) << result.error().message;
  if (counts != nullptr && result) *counts = *result;
  return all;
}

void expect_within_half_a_step(const Outcome& outcome, double timer_hz) {
  const auto pulses = pulses_of(outcome, timer_hz);
  const Machine& machine = outcome.job->machine;
  Motion motion(*outcome.path, outcome.plan);
  const AxisVector start = motion.at(0).position();
  std::array<double, 3> count;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    count[axis] = std::round(start[static_cast<Eigen::Index>(axis)] * machine.axes[axis].steps_per_unit);
  }
  // Half a step, what an axis covers in half a tick at 100 mm/s, and the thousandth at turns.
  const auto check = [&](double time) {
    const AxisVector p = motion.at(time).position();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double steps = machine.axes[axis].steps_per_unit;
      const double off = std::abs(p[static_cast<Eigen::Index>(axis)] * steps - count[axis]);
      ASSERT_LE(off, 0.5 + 100 * steps * 0.5 / timer_hz + 1e-3) << "axis " << axis << " at " << time;
    }
  };
  std::uint64_t last = 0;
  for (const Pulse& pulse : pulses) {
    ASSERT_GE(pulse.ticks, last);
    if (pulse.ticks > last) {
      check((static_cast<double>(last) + 0.5) / timer_hz);
      check((static_cast<double>(pulse.ticks) - 0.5) / timer_hz);
      check((static_cast<double>(last + pulse.ticks)) / 2 / timer_hz);
    }
    count[pulse.axis] += pulse.direction;
    last = pulse.ticks;
  }
  check(outcome.plan.cycle_time());
}

TEST(ProgramPulses, StayWithinHalfAStepOfTheExactMotion) {
  Program program;
  program.start(1.001, 2, 0.3)
      .line(12, 3)
      .arc(8, 3, 5.0, 1.7)
      .line(0, 0)
      .dwell(0.1)
      .line(-3, 0.0004)
      .line(5, 7, -2)
      .arc(5, 10, -9.0);
  for (const CornerRule rule : {CornerRule::stop, CornerRule::servo}) {
    for (const double timer_hz : {1e5, 1e6, 1e8}) {
      toolpace::Setup setup = stepper_setup();
      setup.options.corner.rule = rule;
      expect_within_half_a_step(planned(program, setup), timer_hz);
    }
  }
}

TEST(ProgramPulses, CountExactly) {
  Program program;
  program.line(10, 0).line(10, 5).line(0.00126, 5);
  PulseCounts counts;
  const auto pulses = pulses_of(planned(program, stepper_setup()), 1e6, &counts);
  // X goes 4000 steps up and 4000 − 1 down, since 0.00126 · 400 = 0.504 rounds to 1; Y 5 · 320.5 = 1602.5, half way: not yet.
  EXPECT_EQ(counts.net[0], 1);
  EXPECT_EQ(counts.net[1], 1602);
  EXPECT_EQ(counts.pulses, 4000U + 3999U + 1602U);
  EXPECT_EQ(pulses.size(), counts.pulses);
  EXPECT_EQ(pulses.front().axis, 0);
  EXPECT_EQ(pulses.front().direction, 1);
}

TEST(ProgramPulses, ComeAtKnownTimes) {
  // 0.4 mm/s would be too slow to see; a long cruise at 100 mm/s gives a pulse every 2.5 µm, 25 µs.
  Program program;
  program.line(100, 0);
  const auto pulses = pulses_of(planned(program, stepper_setup()), 1e6);
  EXPECT_EQ(pulses[20001].ticks - pulses[20000].ticks, 25U);
  EXPECT_EQ(pulses[20100].ticks - pulses[20000].ticks, 2500U);
}

TEST(ProgramPulses, RefuseTimersThatDoNotFit) {
  Program program;
  program.line(10, 0);
  const Outcome outcome = planned(program, stepper_setup());
  const TimedMotion motion{*outcome.path, outcome.plan, outcome.node_time};
  const auto code = [&](const Machine& machine, double hz) {
    return program_pulses(motion, machine, hz, [](const std::vector<Pulse>&) -> Result<void> { return {}; })
        .error()
        .code;
  };
  EXPECT_EQ(code(outcome.job->machine, 0), "timer-value");
  EXPECT_EQ(code(outcome.job->machine, 1000), "timer-too-slow");
  EXPECT_EQ(code(outcome.job->machine, 1e18), "timer-value");  // beyond any clock
  EXPECT_EQ(code(Machine{}, 1e6), "no-steppers");
}

}  // namespace
}  // namespace toolpace
