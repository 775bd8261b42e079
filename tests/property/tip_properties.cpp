/// Random chains and programs about the tool's tip: every axis keeps its limits, and the tip stays where it is programmed.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "case_count.h"
#include "random_numbers.h"
#include "toolpace/bound/lower_bound.h"
#include "toolpace/kinematics/chain.h"
#include "toolpace/law/law_table.h"
#include "toolpace/machine/setup.h"
#include "toolpace/nc/reader.h"
#include "toolpace/pipeline/job.h"
#include "toolpace/pipeline/prove.h"
#include "toolpace/sample/motion.h"

namespace toolpace {
namespace {

using namespace testing;

Eigen::Vector3d random_direction(Random& random) {
  if (one_in(random, 2)) return Eigen::Vector3d::Unit(static_cast<Eigen::Index>(random() % 3));
  return Eigen::Vector3d(between(random, -1, 1), between(random, -1, 1), between(random, 0.1, 1)).normalized();
}

Kinematics random_kinematics(Random& random) {
  Kinematics k{{{}, between(random, 20, 200)}, true};
  std::size_t first = 3 + random() % 3, second = 3 + (first - 3 + 1 + random() % 2) % 3;
  for (const std::size_t axis : {first, second}) {
    if (k.chain.joints.size() == 1 && one_in(random, 5)) break;
    k.chain.joints.push_back(
        {axis, one_in(random, 2) ? ChainSide::table : ChainSide::head, random_direction(random),
         Eigen::Vector3d(between(random, -80, 80), between(random, -80, 80), between(random, -80, 80))});
  }
  return k;
}

toolpace::Setup random_machine(Random& random) {
  toolpace::Setup setup = default_setup();
  const double speed = spread(random, 50, 300), acceleration = spread(random, 500, 5000);
  const double jerk = acceleration * spread(random, 20, 200);
  setup.machine.path = {speed, acceleration, acceleration, jerk, jerk};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    AxisLimits& limits = setup.machine.axes[axis];
    const double unit = axis < 3 ? 1.0 : kRadiansPerDegree;
    limits.speed = unit * speed * spread(random, 0.5, 2);
    limits.acceleration = unit * acceleration * spread(random, 0.2, 2);
    limits.jerk = unit * jerk * spread(random, 0.2, 2);
  }
  const auto laws = law_table();
  setup.options.law = laws[random() % laws.size()].kind;
  setup.options.ramps = one_in(random, 2) ? Ramps::block : Ramps::span;
  constexpr CornerRule kRules[] = {CornerRule::stop, CornerRule::servo, CornerRule::junction, CornerRule::blend};
  setup.options.corner.rule = kRules[random() % std::size(kRules)];
  setup.options.corner.tolerance = spread(random, 0.005, 0.1);
  if (one_in(random, 4)) setup.options.lookahead = 1 + random() % 10;
  return setup;
}

/// Lines with small and large turns, rotary axes alone, arcs, dwells; now and then by the axes again.
std::string random_program(Random& random, const Kinematics& kinematics) {
  std::string text = fmt::format("G21 G90 G94 G17\nG0 X{:.3f} Y{:.3f}\nG43.4 H1\nG1 F{:.0f}\n",
                                 between(random, -50, 50), between(random, -50, 50), spread(random, 200, 8000));
  const double step = spread(random, 0.2, 30), turn = spread(random, 0.1, 40);
  const auto words = [&](bool moves, bool turns) {
    std::string list;
    for (const char letter : {'X', 'Y', 'Z'}) {
      if (moves && !one_in(random, 4)) list += fmt::format(" {}{:.4f}", letter, between(random, -step, step));
    }
    for (const RotaryJoint& joint : kinematics.chain.joints) {
      if (turns && !one_in(random, 4))
        list += fmt::format(" {}{:.4f}", kAxisNames[joint.axis], between(random, -turn, turn));
    }
    return list;
  };
  text += "G91\n";
  for (std::size_t blocks = 3 + random() % 12; blocks > 0; --blocks) {
    switch (random() % 10) {
      case 0: text += "G1" + words(false, true) + "\n"; break;
      case 1: text += "G0" + words(true, true) + "\n"; break;
      case 2: {
        const double radius = spread(random, 1, 20);
        text += fmt::format("{} X{:.4f} Y{:.4f} R{:.4f}{}\n", one_in(random, 2) ? "G2" : "G3", radius, radius, radius,
                            words(false, true));
        break;
      }
      case 3: text += "G4 P10\n"; break;
      case 4: text += "G49\nG1" + words(true, true) + "\nG43.4 H1\n"; break;
      default: text += "G1" + words(true, true) + "\n";
    }
  }
  return text + "M30\n";
}

/// What is broken between setpoints, by exact derivatives, or nothing.
std::string broken_limit(const Outcome& o) {
  const bool keeps_jerk = law_row(o.ran.law).bounds_jerk;
  Motion motion(*o.path, o.plan);
  const double end = motion.duration();
  constexpr double kMoving =
      1e-6;  // [mm/s] below it the motion rests at a node, and is on the one segment or the other
  for (int k = 0; k < 997; ++k) {
    const AxisMotion axes = motion.at(end * (k + 0.5) / 997).axes();
    if (motion.along().speed < kMoving) continue;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      const auto i = static_cast<Eigen::Index>(axis);
      const AxisLimits& limits = o.job->machine.axes[axis];
      if (std::abs(axes.speed[i]) > limits.speed * (1 + 1e-6))
        return fmt::format("{} runs at {} of {}", kAxisNames[axis], axes.speed[i], limits.speed);
      if (std::abs(axes.acceleration[i]) > limits.acceleration * (1 + 1e-3))
        return fmt::format("{} accelerates by {} of {}", kAxisNames[axis], axes.acceleration[i], limits.acceleration);
      if (keeps_jerk && std::abs(axes.jerk[i]) > limits.jerk * (1 + 1e-3))
        return fmt::format("{} has a jerk of {} of {}", kAxisNames[axis], axes.jerk[i], limits.jerk);
    }
    const Chain* const chain = o.path->chain_of(motion.segment());
    if (chain == nullptr) continue;
    const double off = (forward(*chain, axes.position).tip - motion.place().head<3>()).norm();
    if (off > 1e-9) return fmt::format("the tip is off by {} mm", off);
  }
  return {};
}

TEST(ProgramsAboutTheTip, KeepEveryAxisWithinItsLimitsAndTheTipOnItsPath) {
  const std::size_t count = test::case_count(30);
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    Random random(seed);
    ReadOptions options;
    options.dialect = Dialect::fanuc;
    options.kinematics = random_kinematics(random);
    if (seed % 3 == 0) options.kinematics.chain.orientation = Orientation::plane;
    const toolpace::Setup setup = random_machine(random);
    const std::string text = random_program(random, options.kinematics);
    auto reading = read_text(text, "random.nc", options);
    ASSERT_TRUE(reading && !reading->refused) << "seed " << seed << "\n" << text;
    auto job = std::make_shared<Job>();
    job->program = std::make_shared<const Reading>(std::move(*reading));
    job->machine = setup.machine;
    job->options = setup.options;
    const auto outcome = run(job);
    ASSERT_TRUE(outcome) << "seed " << seed << ": " << outcome.error().message << "\n" << text;
    const auto broken = broken_checks(*outcome);
    ASSERT_TRUE(broken) << "seed " << seed << ": " << broken.error().message;
    if (!broken->empty()) {
      const Check& c = broken->front();
      FAIL() << "seed " << seed << ": " << check_title(c) << " " << c.value << " of " << c.limit << " at " << c.time
             << " line " << c.line << ", law " << law_row(setup.options.law).id << ", corner "
             << static_cast<int>(setup.options.corner.rule) << "\n"
             << text;
    }
    ASSERT_EQ(broken_limit(*outcome), "") << "seed " << seed << "\n" << text;
    const auto bound = lower_bound(*outcome);
    ASSERT_TRUE(bound);
    ASSERT_LE(*bound, outcome->summary.cycle_time * (1 + 1e-9)) << "seed " << seed << "\n" << text;
  }
}

}  // namespace
}  // namespace toolpace
