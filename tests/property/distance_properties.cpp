/// However long the path before, a program runs as it does alone.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "case_count.h"
#include "random_numbers.h"
#include "random_program_text.h"
#include "toolpace/law/law_table.h"
#include "toolpace/machine/setup.h"
#include "toolpace/nc/reader.h"
#include "toolpace/pipeline/job.h"
#include "toolpace/pipeline/prove.h"
#include "toolpace/sample/motion.h"

namespace toolpace {
namespace {

using namespace testing;

/// There and back along X, so often that it is about so long [mm]; then a rest at the origin.
std::string long_run(double length) {
  std::string text = "G21 G90 G94\nG1 F60000\n";
  constexpr double kStroke = 5000;
  for (double run = 0; run < length; run += 2 * kStroke) text += "X5000\nX0\n";
  return text + "M0\n";
}

Outcome planned_text(const std::string& text, const toolpace::Setup& setup) {
  auto reading = read_text(text, "random.ngc");
  Job job;
  job.program = std::make_shared<const Reading>(std::move(reading.value()));
  job.machine = setup.machine;
  job.options = setup.options;
  auto outcome = run(std::make_shared<const Job>(std::move(job)));
  EXPECT_TRUE(outcome) << outcome.error().message;
  return std::move(outcome.value());
}

/// Axes of their own limits where ramps stay inside blocks: across blocks the way of planning is chosen for a whole program.
toolpace::Setup distance_setup(Random& random, bool& has_curves) {
  toolpace::Setup setup = default_setup();
  setup.machine.path = {1000, 3000, 3000, 1e5, 1e5};
  const auto laws = law_table();
  setup.options.law = laws[random() % laws.size()].kind;
  setup.options.ramps = Ramps::block;
  has_curves = true;
  const bool spans = one_in(random, 3);
  if (spans) {
    constexpr LawKind kHulls[] = {LawKind::trapezoid, LawKind::seven_phase, LawKind::time_optimal};
    setup.options.law = kHulls[random() % std::size(kHulls)];
    setup.options.ramps = Ramps::span;
    has_curves = false;
    return setup;
  }
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const double unit = is_rotary(axis) ? kRadiansPerDegree : 1.0;
    setup.machine.axes[axis].speed = unit * spread(random, 50, 1000);
    setup.machine.axes[axis].acceleration = unit * spread(random, 500, 5000);
    setup.machine.axes[axis].jerk = unit * spread(random, 5000, 2e5);
  }
  return setup;
}

/// A random program, and in it blocks in which an axis turns much while the tip hardly moves.
std::string short_program(Random& random, bool has_curves) {
  std::string text;
  if (has_curves) {
    ProgramText program(random, true);
    for (std::size_t blocks = 1 + random() % 10; blocks > 0; --blocks) program.add_block();
    text = program.finish();
    text.resize(text.size() - 3);  // M2
  } else {
    for (std::size_t blocks = 2 + random() % 20; blocks > 0; --blocks) {
      text += fmt::format("G1 X{:.4f} Y{:.4f} F{:.1f}\n", between(random, -50, 50), between(random, -50, 50),
                          spread(random, 60, 24000));
    }
  }
  for (int k = 0; k < 3; ++k) {
    text += fmt::format("G1 Z{:.4f} A{:.3f} F{:.1f}\n", spread(random, 1e-4, 1e-2), between(random, -180, 180),
                        spread(random, 10, 5000));
  }
  return text + "M2\n";
}

/// When the plan goes on from a node that it rests at.
double begin_of(const MotionPlan& plan, std::size_t node) {
  const auto first = std::find_if(plan.phases.begin(), plan.phases.end(),
                                  [&](const Phase& p) { return p.node == node && p.distance == 0 && p.speed == 0; });
  return first == plan.phases.end() ? -1 : first->begin;
}

TEST(Distance, BehindAProgramRunsAsAlone) {
  for (std::uint64_t seed = 1; seed <= test::case_count(60); ++seed) {
    Random random(seed);
    bool has_curves = false;
    const toolpace::Setup setup = distance_setup(random, has_curves);
    const std::string text = short_program(random, has_curves), run = long_run(spread(random, 2e4, 1e6));
    const Outcome alone = planned_text(text, setup), after = planned_text(run + text, setup);
    const std::size_t segments = after.path->size() - alone.path->size();
    const double begin = begin_of(after.plan, segments), end = alone.plan.cycle_time();
    EXPECT_NEAR(after.plan.cycle_time() - begin, end, 1e-9 * end) << "seed " << seed;
    Motion one(*alone.path, alone.plan), other(*after.path, after.plan);
    constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
    for (int k = 1; k < 1000; ++k) {
      const double t = end * k / 1000;
      const AxisMotion a = one.at(t).axes();
      const AxisVector b = other.at(begin + t).position();
      for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(kAxisCount); ++i) {
        // The clock itself is rounded, and so are coordinates.
        const double clock = 8 * kEpsilon * (begin + t) * (std::abs(a.speed[i]) + 1e-3);
        ASSERT_NEAR(b[i], a.position[i], clock + 256 * kEpsilon * (1 + std::abs(a.position[i]))) << fmt::format(
            "axis {}, {} s, seed {}, law {}\n{}{}", i, t, seed, law_row(setup.options.law).id, run.size(), text);
      }
    }
  }
}

/// Limits of each axis.
toolpace::Setup four_axis_setup() {
  toolpace::Setup setup = default_setup();
  setup.machine.path = {200, 3000, 3000, 1e5, 1e5};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    setup.machine.axes[axis].speed = 100;
    setup.machine.axes[axis].acceleration = 2000;
    setup.machine.axes[axis].jerk = 1e5;
  }
  setup.machine.axes[3].speed = 90 * kRadiansPerDegree;
  setup.machine.axes[3].acceleration = 500 * kRadiansPerDegree;
  setup.machine.axes[3].jerk = 5000 * kRadiansPerDegree;
  return setup;
}

// 178° within 0.2 µm, 20 m from the start: there a rounding of the path length was worth three times the jerk limit.
TEST(Distance, KeepsLimitsOfAnAxisThatTurnsWhileTheTipHardlyMoves) {
  toolpace::Setup setup = four_axis_setup();
  setup.options.corner.rule = CornerRule::stop;
  for (const LawRow& law : law_table()) {
    if (!law.bounds_jerk) continue;
    for (const Ramps ramps : {Ramps::block, Ramps::span}) {
      setup.options.law = law.kind;
      setup.options.ramps = ramps;
      const Outcome o = planned_text(long_run(2e4) + "G1 Z0.0002 A178 F100\nZ0 A0\nM2\n", setup);
      Motion motion(*o.path, o.plan);
      const double period = setup.machine.period, begin = o.node_time[o.path->size() - 2];
      double jerk = 0;
      for (double t = begin; t + 3 * period < o.plan.cycle_time(); t += period) {
        double angle[4];
        for (int k = 0; k < 4; ++k) angle[k] = motion.at(t + k * period).position()[3];
        const double third = (angle[3] - angle[0]) - 3 * (angle[2] - angle[1]);
        jerk = std::max(jerk, std::abs(third) / (period * period * period));
      }
      EXPECT_LE(jerk, setup.machine.axes[3].jerk * 1.001) << law.id;
      EXPECT_TRUE(prove(o).value().passes()) << law.id;
    }
  }
}

// The same without a rest before it: a stroke of 5 m and 0.2 µm in one stretch.
TEST(Distance, KeepsLimitsBehindALongStrokeToo) {
  const toolpace::Setup given = four_axis_setup();
  for (const LawRow& law : law_table()) {
    for (const Ramps ramps : {Ramps::block, Ramps::span}) {
      toolpace::Setup setup = given;
      setup.options.law = law.kind;
      setup.options.ramps = ramps;
      const Outcome o = planned_text("G21 G90 G94\nG1 F60000\nX5000\nX0\nZ0.0002 A178 F100\nZ0 A0\nM2\n", setup);
      EXPECT_TRUE(prove(o).value().passes()) << law.id;
    }
  }
}

}  // namespace
}  // namespace toolpace
