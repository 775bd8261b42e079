/// Programs that go back the way they came: pecks, zigzags, drilling cycles.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "case_count.h"
#include "random_numbers.h"
#include "toolpace/bound/lower_bound.h"
#include "toolpace/machine/setup.h"
#include "toolpace/nc/reader.h"
#include "toolpace/pipeline/job.h"
#include "toolpace/pipeline/prove.h"

namespace toolpace {
namespace {

using namespace testing;

std::string peck(Random& random) {
  std::string text;
  double bottom = 0;
  for (int k = 0; k < 3; ++k) {
    bottom -= spread(random, 0.05, 5);
    text += fmt::format("G1 Z{:.4f} F{:.0f}\nG0 Z{:.4f}\n", bottom, spread(random, 100, 3000),
                        one_in(random, 2) ? 2.0 : bottom + 0.2);
  }
  return text + "G0 Z2\n";
}

/// Strokes along one line, in a direction of their own, now and then with a dwell between them.
std::string zigzag(Random& random, double& x, double& y) {
  const double angle = between(random, -3, 3), step = spread(random, 0.01, 1);
  std::string text;
  for (int k = 0; k < 6; ++k) {
    const double to = step * static_cast<double>(random() % 40);
    text += fmt::format("G1 X{:.10f} Y{:.10f} F{:.0f}\n", x + to * std::cos(angle), y + to * std::sin(angle),
                        spread(random, 100, 12000));
    if (one_in(random, 8)) text += "G4 P0.01\n";
  }
  text += fmt::format("X{:.10f} Y{:.10f}\n", x, y);
  x += between(random, -5, 5);
  y += between(random, -5, 5);
  return text;
}

std::string program(Random& random) {
  std::string text = "G21 G90 G94 G17\nF1200\nG0 X0 Y0 Z2\n";
  double x = 0, y = 0;
  for (std::size_t k = 1 + random() % 6; k > 0; --k) {
    text += fmt::format("G0 X{:.4f} Y{:.4f}\n", x, y);
    switch (random() % 4) {
      case 0: text += peck(random); break;
      case 1:
        text += fmt::format("G83 Z-{:.3f} R1 Q{:.3f} F600\nG80\n", spread(random, 1, 9), spread(random, 0.4, 3));
        break;
      default: text += zigzag(random, x, y); break;
    }
    if (one_in(random, 5)) text += one_in(random, 2) ? "G61\n" : "G64\n";
  }
  return text + "M2\n";
}

toolpace::Setup turning_setup(Random& random) {
  toolpace::Setup setup = default_setup();
  setup.machine.path = {spread(random, 50, 500), 3000, 3000, 1e5, 1e5};
  for (std::size_t axis = 0; axis < 3 && !one_in(random, 4); ++axis) {
    setup.machine.axes[axis].speed = spread(random, 50, 500);
    setup.machine.axes[axis].acceleration = spread(random, 500, 4000);
    setup.machine.axes[axis].jerk = spread(random, 1e4, 2e5);
  }
  setup.options.law = one_in(random, 2) ? LawKind::seven_phase : LawKind::time_optimal;
  setup.options.ramps = Ramps::span;
  constexpr CornerRule kRules[] = {CornerRule::stop, CornerRule::servo, CornerRule::junction, CornerRule::blend};
  setup.options.corner.rule = kRules[random() % std::size(kRules)];
  if (one_in(random, 4)) setup.options.lookahead = 2 + random() % 6;
  return setup;
}

/// Phases that begin at rest with acceleration.
std::size_t turns_in(const MotionPlan& plan) {
  return static_cast<std::size_t>(std::count_if(plan.phases.begin(), plan.phases.end(),
                                                [](const Phase& p) { return p.speed == 0 && p.acceleration > 0; }));
}

TEST(Turning, KeepsEveryLimitAndItsNodesAndIsNoFasterThanTheBound) {
  std::size_t turns = 0;
  for (std::uint64_t seed = 1; seed <= test::case_count(60); ++seed) {
    Random random(seed);
    const toolpace::Setup setup = turning_setup(random);
    const std::string text = program(random);
    const auto describe = [&] { return fmt::format("seed {}\n{}\n{}", seed, format_setup(setup).value(), text); };
    Job job;
    job.program = std::make_shared<const Reading>(read_text(text, "turns.ngc").value());
    job.machine = setup.machine;
    job.options = setup.options;
    const auto outcome = run(std::make_shared<const Job>(job));
    ASSERT_TRUE(outcome) << outcome.error().message << describe();
    EXPECT_TRUE(prove(*outcome).value().passes()) << describe();
    EXPECT_LE(lower_bound(*outcome).value(), outcome->summary.cycle_time) << describe();
    const MotionPlan& plan = outcome->plan;
    if (!plan.splines.empty()) continue;  // phases only sketch a motion through a tube
    for (std::size_t k = 0; k < plan.phases.size(); ++k) {
      const Phase& p = plan.phases[k];
      EXPECT_GE(extrema(p).min_speed, -1e-8) << describe();
      if (k == 0 || !(p.speed == 0 && p.acceleration > 0)) continue;
      // What came before ends at this node, not beyond it, with the same acceleration of the axes.
      const Phase& last = plan.phases[k - 1];
      const PhaseState end = evaluate(last, last.duration);
      const double way = outcome->path->position.between(last.node, p.node);
      EXPECT_NEAR(end.distance, way, 1e-12 * (1 + way)) << describe();
      EXPECT_NEAR(end.acceleration, -p.acceleration, 1e-6 * p.acceleration) << describe();
    }
    turns += turns_in(plan);
  }
  EXPECT_GT(turns, 300u);
}

}  // namespace
}  // namespace toolpace
