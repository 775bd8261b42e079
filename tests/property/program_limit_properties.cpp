/// Random programs that lower the machine's limits on their way: each segment keeps its own, under every law and corner rule.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "case_count.h"
#include "planned_program.h"
#include "random_numbers.h"
#include "random_program_text.h"
#include "toolpace/bound/lower_bound.h"
#include "toolpace/law/law_table.h"
#include "toolpace/limits/ceilings.h"
#include "toolpace/machine/setup.h"
#include "toolpace/nc/reader.h"
#include "toolpace/pipeline/job.h"
#include "toolpace/pipeline/prove.h"
#include "toolpace/sample/motion.h"

namespace toolpace {
namespace {

using namespace testing;

constexpr double kSlack = 1e-6;  // of a limit

MotionCeiling random_ceiling(Random& random, const Machine& machine) {
  MotionCeiling ceiling;
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (one_in(random, 2)) ceiling.speed[k] = machine.path.speed * spread(random, 0.1, 2);
    if (one_in(random, 2)) ceiling.acceleration[k] = machine.path.acceleration * spread(random, 0.1, 2);
    if (one_in(random, 4)) ceiling.corner_step[k] = spread(random, 0.1, 20);
  }
  if (one_in(random, 2)) ceiling.path_speed = machine.path.speed * spread(random, 0.1, 2);
  if (one_in(random, 2)) ceiling.path_acceleration = machine.path.acceleration * spread(random, 0.1, 2);
  if (one_in(random, 4)) ceiling.accuracy = between(random, 0, 1);
  if (one_in(random, 4)) ceiling.corner_speed = spread(random, 0.1, 20);
  if (one_in(random, 4)) ceiling.junction_deviation = spread(random, 1e-4, 0.1);
  return ceiling;
}

/// Lowers limits from row to row, now and then others.
void lower_limits(Random& random, const Machine& machine, Moves& moves) {
  for (std::size_t n = 1 + random() % 3; n > 0; --n) moves.ceilings.push_back(random_ceiling(random, machine));
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::uint16_t> known;
  std::uint16_t ceiling = 0;
  for (std::uint16_t& mode : moves.mode) {
    if (one_in(random, 4)) ceiling = static_cast<std::uint16_t>(random() % moves.ceilings.size());
    const auto [at, is_new] = known.try_emplace({mode, ceiling}, static_cast<std::uint16_t>(moves.modes.size()));
    if (is_new) {
      moves.modes.push_back(moves.modes[mode]);
      moves.modes.back().ceiling = ceiling;
    }
    mode = at->second;
  }
}

toolpace::Setup random_setup(Random& random) {
  toolpace::Setup setup = default_setup();
  const double speed = spread(random, 50, 300), acceleration = spread(random, 500, 5000);
  const double jerk = acceleration * spread(random, 20, 300);
  setup.machine.path = {speed, acceleration, acceleration, jerk, jerk};
  setup.machine.path.fine_acceleration = acceleration * spread(random, 0.2, 2);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    setup.machine.axes[axis].speed = speed * spread(random, 0.5, 2);
    setup.machine.axes[axis].acceleration = acceleration * spread(random, 0.5, 2);
    setup.machine.axes[axis].jerk = jerk * spread(random, 0.5, 2);
  }
  const auto laws = law_table();
  setup.options.law = laws[random() % laws.size()].kind;
  setup.options.ramps = one_in(random, 2) ? Ramps::block : Ramps::span;
  constexpr CornerRule kRules[] = {CornerRule::stop, CornerRule::servo, CornerRule::junction, CornerRule::blend,
                                   CornerRule::smooth};
  setup.options.corner.rule = kRules[random() % std::size(kRules)];
  setup.options.corner.tolerance = spread(random, 0.005, 0.1);
  return setup;
}

std::shared_ptr<const Job> random_job(Random& random, std::string& text) {
  const toolpace::Setup setup = random_setup(random);
  ProgramText program(random, false);
  const std::size_t most = setup.options.corner.rule == CornerRule::smooth ? 8 : 25;
  for (std::size_t blocks = 2 + random() % most; blocks > 0; --blocks) program.add_block();
  text = program.finish();
  auto reading = read_text(text, "random.ngc").value();
  lower_limits(random, setup.machine, reading.moves);
  auto job = std::make_shared<Job>();
  job->program = std::make_shared<const Reading>(std::move(reading));
  job->machine = setup.machine;
  job->options = setup.options;
  return job;
}

/// The same job of a program that lowers nothing.
std::shared_ptr<const Job> without_limits(const Job& job) {
  auto reading = std::make_shared<Reading>(*job.program);
  for (MoveMode& mode : reading->moves.modes) mode.ceiling = 0;
  auto free = std::make_shared<Job>(job);
  free->program = std::move(reading);
  return free;
}

/// What is exceeded in the middle of phases and of segments, or nothing.
std::string broken_limit(const Outcome& o) {
  const std::vector<Machine> machines = machines_under(o.job->machine, *o.commands);
  Motion motion(*o.path, o.plan);
  std::vector<double> times;
  for (std::size_t i = 0; i + 1 < o.node_time.size(); ++i) {
    for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9})
      times.push_back(o.node_time[i] + share * (o.node_time[i + 1] - o.node_time[i]));
  }
  std::sort(times.begin(), times.end());
  for (const double time : times) {
    motion.at(time);
    if (motion.leaves_path())
      continue;  // knot intervals do not end where segments do: the setpoints' proof judges them
    const Machine& m = machines[(*o.commands)[motion.segment()].ceiling];
    const AxisMotion axes = motion.axes();
    const PhaseState s = motion.along();
    if (s.speed > m.path.speed * (1 + kSlack)) return fmt::format("speed {} > {} at {}", s.speed, m.path.speed, time);
    if (std::abs(s.acceleration) > m.path.acceleration * (1 + kSlack))
      return fmt::format("acceleration {} > {} at {}", s.acceleration, m.path.acceleration, time);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      if (std::abs(axes.speed[i]) > m.axes[k].speed * (1 + kSlack))
        return fmt::format("axis {} speed {} > {} at {}", k, axes.speed[i], m.axes[k].speed, time);
      if (std::abs(axes.acceleration[i]) > m.axes[k].acceleration * (1 + 1e-3))
        return fmt::format("axis {} acceleration {} > {} at {}", k, axes.acceleration[i], m.axes[k].acceleration, time);
    }
  }
  return {};
}

TEST(LimitsThatProgramsLower, AreKeptBySegmentsAndByNoPlanBeaten) {
  const std::size_t count = test::case_count(8);
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    Random random(seed);
    std::string text;
    const auto job = random_job(random, text);
    const auto outcome = run(job);
    ASSERT_TRUE(outcome) << outcome.error().message << ", seed " << seed << "\n" << text;
    EXPECT_EQ(broken_limit(*outcome), "") << "seed " << seed << "\n" << text;
    const auto report = prove(*outcome);
    ASSERT_TRUE(report);
    EXPECT_TRUE(report->passes()) << broken(*report) << "seed " << seed << "\n" << text;
    const double time = outcome->summary.cycle_time;
    EXPECT_LE(lower_bound(*outcome).value(), time * (1 + 1e-6)) << "seed " << seed << "\n" << text;
    const auto free = run(without_limits(*job));
    ASSERT_TRUE(free);
    EXPECT_LE(lower_bound(*free).value(), time * (1 + 1e-6)) << "seed " << seed << "\n" << text;
  }
}

// On lines with corners that are crossed, plans of one law are as fast as it can be done: lower limits cost time, never gain any.
TEST(LimitsThatProgramsLower, NeverMakeAPlanOnLinesFaster) {
  const std::size_t count = test::case_count(20);
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    Random random(seed);
    toolpace::Setup setup = random_setup(random);
    setup.options.law = one_in(random, 2) ? LawKind::trapezoid : LawKind::quintic;
    setup.options.ramps = setup.options.law == LawKind::trapezoid ? Ramps::span : Ramps::block;
    setup.options.corner.rule = one_in(random, 2) ? CornerRule::servo : CornerRule::junction;
    std::string text = "G21 G90 G94\n";
    for (int k = 0; k < 12; ++k)
      text += fmt::format("G1 X{:.3f} Y{:.3f} F{:.0f}\n", between(random, 0, 30), between(random, 0, 30),
                          spread(random, 300, 20000));
    auto reading = read_text(text + "M2\n", "random.ngc").value();
    lower_limits(random, setup.machine, reading.moves);
    auto job = std::make_shared<Job>();
    job->program = std::make_shared<const Reading>(std::move(reading));
    job->machine = setup.machine;
    job->options = setup.options;
    const auto lowered = run(job), free = run(without_limits(*job));
    ASSERT_TRUE(lowered && free);
    EXPECT_GE(lowered->summary.cycle_time, free->summary.cycle_time * (1 - 1e-9)) << "seed " << seed << "\n" << text;
  }
}

}  // namespace
}  // namespace toolpace
