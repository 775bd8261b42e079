/// Dials of a job: with a higher limit, feed or override, or a deeper look-ahead, a program never takes longer.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "case_count.h"
#include "random_numbers.h"
#include "random_program_text.h"
#include "toolpace/law/law_table.h"
#include "toolpace/machine/setup.h"
#include "toolpace/nc/reader.h"
#include "toolpace/pipeline/job.h"

namespace toolpace {
namespace {

using namespace testing;

toolpace::Setup dial_setup(Random& random) {
  toolpace::Setup setup = default_setup();
  const double speed = spread(random, 20, 500), acceleration = spread(random, 300, 10000);
  const double jerk = acceleration * spread(random, 10, 300);
  setup.machine.path = {speed, acceleration, acceleration, jerk, jerk};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (one_in(random, 4) && !is_rotary(axis)) continue;
    const double unit = is_rotary(axis) ? kRadiansPerDegree : 1.0;
    setup.machine.axes[axis].speed = speed * spread(random, 0.3, 2) * unit;
    setup.machine.axes[axis].acceleration = acceleration * spread(random, 0.3, 2) * unit;
    setup.machine.axes[axis].jerk = jerk * spread(random, 0.3, 2) * unit;
  }
  const auto laws = law_table();
  setup.options.law = laws[random() % laws.size()].kind;
  setup.options.ramps = one_in(random, 2) ? Ramps::block : Ramps::span;
  constexpr CornerRule kRules[] = {CornerRule::stop, CornerRule::servo, CornerRule::junction, CornerRule::blend};
  setup.options.corner.rule = kRules[random() % std::size(kRules)];
  setup.options.corner.tolerance = spread(random, 0.002, 0.2);
  if (one_in(random, 3)) setup.options.lookahead = 1 + random() % 12;
  return setup;
}

constexpr std::size_t kDials = 9;

/// Turns one dial towards faster by a factor.
std::string turn(std::size_t dial, double factor, std::size_t axis, Job& job) {
  PathLimits& path = job.machine.path;
  AxisLimits& one = job.machine.axes[axis];
  switch (dial) {
    case 0: job.options.feed_override *= factor; return "override";
    case 1: path.speed *= factor; return "path speed";
    case 2: path.acceleration *= factor; return "path acceleration";
    case 3: path.deceleration *= factor; return "path deceleration";
    case 4: path.jerk *= factor; return "path jerk";
    case 5: one.speed *= factor; return "axis speed";
    case 6: one.acceleration *= factor; return "axis acceleration";
    case 7: one.jerk *= factor; return "axis jerk";
    default:
      if (job.options.lookahead) *job.options.lookahead += 1 + static_cast<std::size_t>(8 * (factor - 1));
      return "look-ahead";
  }
}

Result<double> cycle_time(const Job& job) {
  const auto outcome = run(std::make_shared<const Job>(job));
  if (!outcome) return tl::unexpected(outcome.error());
  return outcome->summary.cycle_time;
}

/// The share by which a program may be slower under the better setting. Where curves are timed anew, or corners rounded through
/// the tube, the search stops some thousandths from the fastest motion.
double tolerated(const Job& job) { return job.options.ramps == Ramps::span ? 0.005 : 0.001; }

TEST(Dials, TurnedTowardsFasterNeverCostTime) {
  for (std::uint64_t seed = 1; seed <= test::case_count(25); ++seed) {
    Random random(seed);
    const toolpace::Setup setup = dial_setup(random);
    ProgramText program(random, one_in(random, 4));
    for (std::size_t blocks = 2 + random() % 20; blocks > 0; --blocks) program.add_block();
    auto reading = read_text(program.finish(), "random.ngc");
    ASSERT_TRUE(reading);
    Job job;
    job.program = std::make_shared<const Reading>(std::move(*reading));
    job.machine = setup.machine;
    job.options = setup.options;
    const auto before = cycle_time(job);
    ASSERT_TRUE(before) << before.error().message << ", seed " << seed;
    for (int k = 0; k < 3; ++k) {
      Job easier = job;
      const std::string dial = turn(random() % kDials, 1 + between(random, 0.02, 1), random() % 4, easier);
      const auto after = cycle_time(easier);
      ASSERT_TRUE(after) << after.error().message << ", seed " << seed;
      EXPECT_LE(*after, *before * (1 + tolerated(job)))
          << fmt::format("{}, seed {}, law {}\n{}\n{}", dial, seed, law_row(job.options.law).id, program.finish(),
                         format_setup(setup).value());
    }
  }
}

}  // namespace
}  // namespace toolpace
