#include "toolpace/sample/motion.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "planned_program.h"
#include "toolpace/plan/plan.h"

namespace toolpace {
namespace {

using namespace testing;

/// Lines, an arc, a helix, a rest and a corner.
Program mixed_program() {
  return Program()
      .line(20, 0)
      .arc(20, 8, 2.0)
      .line(40, 30)
      .dwell(0.1)
      .line(40, 45)
      .arc(45, 45, -4.0, 3)
      .line(60, 20, 5);
}

Outcome planned_with(const Program& program, CornerRule rule, LawKind law = LawKind::quintic) {
  toolpace::Setup setup = axis_limited_setup();
  setup.options.law = law;
  setup.options.ramps = Ramps::span;
  setup.options.corner.rule = rule;
  setup.options.corner.tolerance = 0.05;
  return planned(program, setup);
}

std::vector<Outcome> every_kind() {
  std::vector<Outcome> outcomes;
  outcomes.push_back(planned_with(mixed_program(), CornerRule::servo));
  outcomes.push_back(planned_with(mixed_program(), CornerRule::blend, LawKind::seven_phase));
  outcomes.push_back(planned_with(Program().line(10, 0).line(12, 5).line(20, 5, 2).dwell(0.05).line(20, 15).line(3, 9),
                                  CornerRule::smooth, LawKind::seven_phase));
  EXPECT_FALSE(outcomes.back().plan.splines.empty());
  outcomes.push_back(planned_with(Program().line(5, 0).rotate(1.5, 60).line(9, 9), CornerRule::servo));
  return outcomes;
}

TEST(Motion, IsTheSameInWhateverOrderItsInstantsAreAskedFor) {
  std::mt19937 random(7);
  for (const Outcome& o : every_kind()) {
    Motion rising(*o.path, o.plan), jumping(*o.path, o.plan);
    std::vector<std::pair<double, AxisVector>> instants;
    for (int k = 0; k <= 2000; ++k) {
      const double time = o.plan.cycle_time() * k / 2000;
      instants.emplace_back(time, rising.at(time).position());
    }
    std::shuffle(instants.begin(), instants.end(), random);
    for (const auto& [time, position] : instants) {
      EXPECT_LT((jumping.at(time).position() - position).norm(), 1e-12) << "at " << time;
    }
  }
}

TEST(Motion, BeginsAndEndsAtTheEndsOfThePathToTheBit) {
  for (const Outcome& o : every_kind()) {
    Motion motion(*o.path, o.plan);
    EXPECT_EQ(motion.at(motion.duration() + 1).position(), o.path->node.back());
    EXPECT_EQ(motion.at(-1).position(), o.path->node.front());
  }
}

// Central differences over 2·10⁻⁶ s: their own error is below what the tolerances leave, except across a seam.
TEST(Motion, DerivativesOfTheAxesAreThoseOfTheirPositions) {
  constexpr double kStep = 1e-6;
  for (const Outcome& o : every_kind()) {
    Motion motion(*o.path, o.plan);
    int far = 0;
    for (int k = 1; k < 2000; ++k) {
      const double time = motion.duration() * k / 2000;
      const AxisMotion before = motion.at(time - kStep).axes(), here = motion.at(time).axes();
      const AxisMotion after = motion.at(time + kStep).axes();
      EXPECT_EQ(here.position, motion.at(time).position());
      const auto off = [&](const AxisVector& a, const AxisVector& b, const AxisVector& derivative, double scale) {
        return ((b - a) / (2 * kStep) - derivative).norm() > scale;
      };
      far += off(before.position, after.position, here.speed, 1e-3) ||
             off(before.speed, after.speed, here.acceleration, 1.0) ||
             off(before.acceleration, after.acceleration, here.jerk, 1e3);
    }
    EXPECT_LT(far, 20);
  }
}

TEST(Motion, IsAsFastAlongItsWayAsItsAxesSay) {
  for (const Outcome& o : every_kind()) {
    Motion motion(*o.path, o.plan);
    for (int k = 0; k < 500; ++k) {
      motion.at(motion.duration() * k / 500);
      const Metric metric = metric_along(*o.path, motion.segment());
      EXPECT_NEAR(metric.norm(motion.axes().speed), motion.along().speed, 1e-9 * (1 + motion.along().speed));
    }
  }
}

TEST(Motion, BoundsHoldEveryInstantAndAreReached) {
  std::mt19937 random(11);
  for (const Outcome& o : every_kind()) {
    Motion motion(*o.path, o.plan), instant(*o.path, o.plan);
    std::uniform_real_distribution<double> time(0, motion.duration());
    for (int window = 0; window < 60; ++window) {
      const auto [begin, end] = std::minmax({time(random), time(random)});
      const PhaseBounds box = motion.bounds(begin, end);
      double highest = 0;
      for (int k = 0; k <= 400; ++k) {
        const PhaseState s = instant.at(begin + (end - begin) * k / 400).along();
        ASSERT_LE(s.speed, box.speed.high * (1 + 1e-3) + 1e-9);
        ASSERT_GE(s.speed, box.speed.low - 1e-3 * (1 + std::abs(box.speed.low)));
        if (instant.leaves_path()) continue;  // of instants there
        ASSERT_LE(s.acceleration, box.acceleration.high + 1e-6);
        ASSERT_GE(s.acceleration, box.acceleration.low - 1e-6);
        highest = std::max(highest, s.speed);
      }
      EXPECT_LE(highest, box.speed.high + 1e-9);
    }
  }
}

TEST(Motion, BoundsOfAnAxisHoldEveryInstant) {
  std::mt19937 random(13);
  for (const Outcome& o : every_kind()) {
    Motion motion(*o.path, o.plan), instant(*o.path, o.plan);
    std::uniform_real_distribution<double> time(0, motion.duration());
    for (int window = 0; window < 60; ++window) {
      const auto [begin, end] = std::minmax({time(random), time(random)});
      for (std::size_t axis = 0; axis < 4; ++axis) {
        const PhaseBounds box = motion.bounds(begin, end, axis);
        for (int k = 0; k <= 200; ++k) {
          const auto i = static_cast<Eigen::Index>(axis);
          const double v = instant.at(begin + (end - begin) * k / 200).axes().speed[i];
          const double slack = 1e-9 + 0.03 * (box.speed.high - box.speed.low);  // curves are seen at eight instants
          ASSERT_LE(v, box.speed.high + slack) << "axis " << axis;
          ASSERT_GE(v, box.speed.low - slack) << "axis " << axis;
        }
      }
    }
  }
}

// X and then Y at one speed through a corner: each side has its own direction.
TEST(Motion, StandsOnTheAskedSideOfANode) {
  toolpace::Setup setup = axis_limited_setup();
  setup.options.corner.step = 1000;
  const Outcome o = planned(Program().line(20, 0).line(20, 20), setup);
  Motion motion(*o.path, o.plan);
  const double corner = o.node_time[1];
  const AxisMotion before = motion.at(corner, 0).axes(), after = motion.at(corner, 1).axes();
  ASSERT_GT(before.speed[0], 1);
  EXPECT_EQ(before.speed[1], 0);
  EXPECT_EQ(after.speed[0], 0);
  EXPECT_NEAR(after.speed[1], before.speed[0], 1e-9);
  EXPECT_LT((before.position - after.position).norm(), 1e-12);
  // The bounds of a block know nothing of its neighbour.
  EXPECT_EQ(motion.bounds(0, corner, 1).speed.high, 0);
}

TEST(Motion, ComesToAPositionAndLeavesItAfterItsRest) {
  const Outcome o = planned_with(mixed_program(), CornerRule::servo);
  Motion motion(*o.path, o.plan);
  for (int k = 1; k < 300; ++k) {
    const double position = o.path->position.back() * k / 300;
    const double time = motion.time_at(position);
    EXPECT_NEAR(motion.at(time).along().distance, position, 1e-9);
  }
  const std::size_t rest = o.path->pauses.front().node;
  EXPECT_NEAR(motion.time_at(o.path->position[rest]), o.node_time[rest] + 0.1, 1e-9);
}

// 2·10⁵ segments of 0.1 mm: the sum of their lengths rounds 2·10⁵ times if it is let.
TEST(Motion, DoesNotGrowLessExactWithThePathItHasRun) {
  Program program;
  for (int i = 1; i <= 200'000; ++i) program.line(0.1 * i, i % 2 == 0 ? 0 : 1e-3);
  const Path path = build_path(program.moves(), 0).value();
  long double exact = 0;
  for (std::size_t i = 0; i < path.size(); i += 1000) {  // in parts, so that this sum rounds less
    exact += std::accumulate(path.length.begin() + static_cast<std::ptrdiff_t>(i),
                             path.length.begin() + static_cast<std::ptrdiff_t>(i + 1000), 0.0L);
  }
  EXPECT_NEAR(path.position.back(), static_cast<double>(exact), 1e-11);
  EXPECT_EQ(path.position.front(), 0);
  EXPECT_EQ(path.position.size(), path.node.size());
}

}  // namespace
}  // namespace toolpace
