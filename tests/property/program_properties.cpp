/// Random NC programs of every kind of motion, under every corner rule, with overrides and feed holds: read, planned,
/// sampled and proven.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "random_numbers.h"
#include "random_program_text.h"
#include "setpoint_tally.h"
#include "toolpace/law/law_table.h"
#include "toolpace/nc/reader.h"

namespace toolpace {
namespace {

using namespace testing;

toolpace::Setup random_setup(Random& random, bool rotary) {
  toolpace::Setup setup = default_setup();
  const double speed = spread(random, 20, 500), acceleration = spread(random, 300, 10000);
  const double jerk = acceleration * spread(random, 10, 300);
  setup.machine.path = {speed, acceleration, acceleration * between(random, 0.5, 1), jerk,
                        jerk * between(random, 0.5, 1)};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (one_in(random, 4) && !is_rotary(axis)) continue;
    const double unit = is_rotary(axis) ? kRadiansPerDegree : 1.0;
    setup.machine.axes[axis].speed = speed * spread(random, 0.3, 2) * unit;
    setup.machine.axes[axis].acceleration = acceleration * spread(random, 0.3, 2) * unit;
    setup.machine.axes[axis].jerk = jerk * spread(random, 0.3, 2) * unit;
  }
  constexpr double kPeriods[] = {0.0005, 0.001, 0.001, 0.002, 0.004};
  setup.machine.period = kPeriods[random() % std::size(kPeriods)];
  setup.machine.tool_change = one_in(random, 2) ? 0.05 : 0.0;
  const auto laws = law_table();
  setup.options.law = laws[random() % laws.size()].kind;
  setup.options.ramps = one_in(random, 2) ? Ramps::block : Ramps::span;
  constexpr CornerRule kRules[] = {CornerRule::stop,  CornerRule::servo, CornerRule::junction,
                                   CornerRule::blend, CornerRule::blend, CornerRule::smooth};
  setup.options.corner.rule = kRules[random() % (rotary ? std::size(kRules) - 1 : std::size(kRules))];
  setup.options.corner.tolerance = spread(random, 0.002, 0.2);
  if (one_in(random, 3)) setup.options.lookahead = 1 + random() % 20;
  if (one_in(random, 4)) setup.options.feed_override = between(random, 0.2, 2);
  if (one_in(random, 4)) setup.options.rapid_override = between(random, 0.2, 1);
  if (one_in(random, 3)) setup.options.hold_at = between(random, 0, 2);
  return setup;
}

std::string described(const toolpace::Setup& setup, const std::string& text) {
  const PlanOptions& o = setup.options;
  return fmt::format("law {}, corner {}, tolerance {}, ramps {}, lookahead {}, override {}, hold {}, period {}\n{}\n{}",
                     law_row(o.law).id, static_cast<int>(o.corner.rule), o.corner.tolerance, static_cast<int>(o.ramps),
                     o.lookahead.value_or(0), o.feed_override, o.hold_at.value_or(-1), setup.machine.period, text,
                     format_setup(setup).value());
}

void prove_program(std::uint64_t seed, SetpointTally& tally) {
  Random random(seed);
  const bool rotary = one_in(random, 4);
  const toolpace::Setup setup = random_setup(random, rotary);
  const bool smooth = setup.options.corner.rule == CornerRule::smooth;
  ProgramText program(random, rotary);
  for (std::size_t blocks = 2 + random() % (smooth ? 12 : 40); blocks > 0; --blocks) program.add_block();
  const std::string text = program.finish();
  auto reading = read_text(text, "random.ngc");
  ASSERT_TRUE(reading);
  ASSERT_FALSE(reading->refused) << reading->diagnostics.at(0).message << "\n" << text;
  auto job = std::make_shared<Job>();
  job->program = std::make_shared<const Reading>(std::move(*reading));
  job->machine = setup.machine;
  job->options = setup.options;
  const auto outcome = run(job);
  if (!outcome && outcome.error().code == std::string("hold-after-end")) return;
  ASSERT_TRUE(outcome) << outcome.error().message << ", seed " << seed << "\n" << described(setup, text);
  tally.judge(*outcome, [&] { return fmt::format("seed {}, {}", seed, described(setup, text)); });
}

TEST(SetpointsOfRandomNcPrograms, KeepEveryLimit) {
  SetpointTally tally(24);
  for (std::uint64_t seed = 1; tally.wants_more(); ++seed) prove_program(seed, tally);
}

}  // namespace
}  // namespace toolpace
