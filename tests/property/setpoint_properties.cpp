/// Random programs on random machines: the setpoints of every plan keep every limit, follow the path and end at its end.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "random_numbers.h"
#include "setpoint_tally.h"
#include "toolpace/law/law_table.h"

namespace toolpace {
namespace {

using namespace testing;

Program random_program(Random& random) {
  Program program;
  program.start(between(random, -50, 50), between(random, -50, 50), between(random, -5, 5));
  const std::size_t blocks = 1 + random() % 60;
  const double size = spread(random, 0.05, 40);
  double heading = between(random, -3, 3);
  double x = program.moves().start[0], y = program.moves().start[1], z = program.moves().start[2];
  for (std::size_t i = 0; i < blocks; ++i) {
    const double feed = spread(random, 1, 400);
    const unsigned kind = static_cast<unsigned>(random() % 20);
    heading += between(random, -1, 1) * (random() % 4 == 0 ? 3 : 0.3);
    if (kind < 13) {
      const double length = size * spread(random, 0.05, 2);
      x += length * std::cos(heading);
      y += length * std::sin(heading);
      z += random() % 5 == 0 ? between(random, -1, 1) : 0;
      program.line(x, y, z, feed);
    } else if (kind < 18) {
      const double radius = size * spread(random, 0.1, 3), turn = random() % 2 == 0 ? 1 : -1;
      // Half of the arcs go on in the direction of the line before.
      const double along = random() % 2 == 0 ? heading : between(random, -3, 3);
      const double sweep = turn * spread(random, 0.05, 7);
      program.arc(x - turn * radius * std::sin(along), y + turn * radius * std::cos(along), sweep,
                  random() % 3 == 0 ? between(random, -2, 2) : 0, feed);
      heading = along + sweep;
    } else if (kind == 18) {
      program.dwell(between(random, 0, 0.02));
    } else {
      program.line(x, y, z, feed);  // no motion
    }
    const AxisVector& at = program.moves().end.back();
    x = at[0], y = at[1], z = at[2];
  }
  return program;
}

toolpace::Setup random_setup(Random& random) {
  toolpace::Setup setup = default_setup();
  const double speed = spread(random, 20, 500), acceleration = spread(random, 200, 10000);
  const double jerk = acceleration * spread(random, 5, 500);
  setup.machine.path = {speed, acceleration, acceleration * between(random, 0.5, 1), jerk,
                        jerk * between(random, 0.5, 1)};
  for (std::size_t axis = 0; axis < 3 && random() % 4 != 0; ++axis) {
    setup.machine.axes[axis].speed = speed * spread(random, 0.3, 2);
    setup.machine.axes[axis].acceleration = acceleration * spread(random, 0.3, 2);
    setup.machine.axes[axis].jerk = jerk * spread(random, 0.3, 2);
  }
  constexpr double kPeriods[] = {0.0005, 0.001, 0.001, 0.002, 0.004, 1.0 / 3000};
  setup.machine.period = kPeriods[random() % std::size(kPeriods)];
  const auto laws = law_table();
  setup.options.law = laws[random() % laws.size()].kind;
  setup.options.ramps = random() % 2 == 0 ? Ramps::block : Ramps::span;
  constexpr CornerRule kRules[] = {CornerRule::stop, CornerRule::servo, CornerRule::junction};
  setup.options.corner.rule = kRules[random() % std::size(kRules)];
  if (random() % 3 == 0) setup.options.lookahead = 1 + random() % 20;
  setup.options.feed_override = random() % 4 == 0 ? between(random, 0.2, 2) : 1.0;
  return setup;
}

TEST(SetpointsOfRandomPrograms, KeepEveryLimit) {
  SetpointTally tally(60);
  for (std::uint64_t seed = 1; tally.wants_more(); ++seed) {
    Random random(seed);
    auto job = std::make_shared<Job>();
    job->program = random_program(random).reading();
    const toolpace::Setup setup = random_setup(random);
    job->machine = setup.machine;
    job->options = setup.options;
    const auto outcome = run(job);
    ASSERT_TRUE(outcome) << outcome.error().message << ", seed " << seed;
    tally.judge(*outcome, [&] {
      return fmt::format("seed {}, law {}, corner {}, ramps {}, period {}", seed, law_row(setup.options.law).id,
                         static_cast<int>(setup.options.corner.rule), static_cast<int>(setup.options.ramps),
                         setup.machine.period);
    });
  }
}

}  // namespace
}  // namespace toolpace
