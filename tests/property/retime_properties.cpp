/// Random programs whose blended corners are timed anew under the axes' own limits: the setpoints keep these.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "random_numbers.h"
#include "random_program_text.h"
#include "setpoint_tally.h"
#include "toolpace/nc/reader.h"
#include "toolpace/pipeline/strategy.h"

namespace toolpace {
namespace {

using namespace testing;

/// Limits of the axes alone, so that curves are worth timing anew; periods short enough to see what happens inside a knot
/// interval of the retimed motion.
toolpace::Setup random_setup(Random& random) {
  toolpace::Setup setup = default_setup();
  const double speed = spread(random, 20, 500), acceleration = spread(random, 300, 10000);
  const double jerk = acceleration * spread(random, 5, 300);
  setup.machine.path = {};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    setup.machine.axes[axis].speed = speed * spread(random, 0.5, 2);
    setup.machine.axes[axis].acceleration = acceleration * spread(random, 0.5, 2);
    setup.machine.axes[axis].jerk = jerk * spread(random, 0.5, 2);
  }
  if (one_in(random, 3)) setup.machine.path.jerk = setup.machine.path.jerk_deceleration = jerk;
  constexpr double kPeriods[] = {0.00025, 0.0005, 0.001};
  setup.machine.period = kPeriods[random() % std::size(kPeriods)];
  setup.options.law = one_in(random, 2) ? LawKind::seven_phase : LawKind::time_optimal;
  setup.options.ramps = Ramps::span;
  setup.options.corner.rule = CornerRule::blend;
  setup.options.corner.tolerance = spread(random, 0.002, 0.5);
  return setup;
}

TEST(SetpointsOfRetimedPrograms, KeepTheLimitsOfEveryAxis) {
  SetpointTally tally(8);
  std::size_t faster = 0, programs = 0;
  for (std::uint64_t seed = 1; tally.wants_more(); ++seed, ++programs) {
    Random random(seed);
    auto job = std::make_shared<Job>();
    const toolpace::Setup setup = random_setup(random);
    job->machine = setup.machine;
    job->options = setup.options;
    ProgramText program(random, false);
    for (std::size_t blocks = 2 + random() % 40; blocks > 0; --blocks) program.add_block();
    auto reading = read_text(program.finish(), "random.ngc");
    ASSERT_TRUE(reading);
    job->program = std::make_shared<const Reading>(std::move(*reading));
    const auto describe = [&] {
      return fmt::format("seed {}\n{}\n{}", seed, program.finish(), format_setup(setup).value());
    };
    const auto outcome = run(job), quick = run(quick_version(*job));
    ASSERT_TRUE(outcome && quick) << describe();
    faster += outcome->summary.cycle_time < quick->summary.cycle_time;
    tally.judge(*outcome, describe);
  }
  EXPECT_GT(faster, programs / 4);
}

}  // namespace
}  // namespace toolpace
