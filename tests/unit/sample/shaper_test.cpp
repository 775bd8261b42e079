#include "toolpace/sample/shaper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "toolpace/machine/setup.h"
#include "toolpace/nc/reader.h"
#include "toolpace/pipeline/prove.h"
#include "toolpace/pipeline/sampled.h"
#include "toolpace/sample/shaper_band.h"
#include "toolpace/servo/vibration.h"

namespace toolpace {
namespace {

TEST(Shaper, ImpulsesArePositiveAndSumToOne) {
  for (const ShaperKind kind : kShaperKinds) {
    for (const double damping : {0.0, 0.05, 0.3}) {
      const Impulses impulses = shaper_for(kind, 30, damping);
      double sum = 0, last = -1;
      for (const Impulse& i : impulses) {
        EXPECT_GT(i.share, 0) << shaper_name(kind);
        EXPECT_GT(i.time, last);
        sum += i.share;
        last = i.time;
      }
      EXPECT_EQ(impulses.front().time, 0);
      EXPECT_NEAR(sum, 1, 1e-15);
    }
  }
}

TEST(Shaper, LeavesAtItsFrequencyWhatItIsMadeToLeave) {
  for (const double damping : {0.0, 0.02, 0.2}) {
    EXPECT_LT(residual_share(shaper_for(ShaperKind::zv, 30, damping), 30, damping), 1e-12);
    EXPECT_LT(residual_share(shaper_for(ShaperKind::zvd, 30, damping), 30, damping), 1e-12);
    EXPECT_NEAR(residual_share({{0, 1}}, 30, damping), 1, 1e-15);
  }
  EXPECT_NEAR(residual_share(shaper_for(ShaperKind::ei, 30, 0), 30, 0), 0.05, 1e-9);
}

/// Width of the band, as a share of the frequency, in which no more than 5 % are left.
double insensitivity(ShaperKind kind) {
  const Impulses impulses = shaper_for(kind, 1, 0);
  constexpr double kStep = 1e-4, kAllowed = 0.05 + 1e-9;
  double low = 1, high = 1;
  while (residual_share(impulses, low - kStep, 0) <= kAllowed) low -= kStep;
  while (residual_share(impulses, high + kStep, 0) <= kAllowed) high += kStep;
  return high - low;
}

// Singhose, Seering, Singer: "Input shaping for vibration reduction with specified insensitivity to modeling errors", 1996.
TEST(Shaper, HasThePublishedInsensitivityAtFivePerCent) {
  EXPECT_NEAR(insensitivity(ShaperKind::zv), 0.06, 0.005);
  EXPECT_NEAR(insensitivity(ShaperKind::zvd), 0.29, 0.005);
  EXPECT_NEAR(insensitivity(ShaperKind::ei), 0.40, 0.005);
  EXPECT_NEAR(insensitivity(ShaperKind::two_hump), 0.726, 0.005);
}

TEST(Shaper, ForSeveralModesKillsEachAndCountsEqualOnesOnce) {
  std::array<ServoAxis, kAxisCount> servo;
  EXPECT_EQ(shaping(ShaperKind::zv, servo).size(), 1u);
  servo[0].resonance = 28;
  servo[1].resonance = 41;
  servo[2] = servo[0];
  const Impulses both = shaping(ShaperKind::zv, servo);
  EXPECT_EQ(both.size(), 4u);
  EXPECT_LT(residual_share(both, 28, 0.05), 1e-12);
  EXPECT_LT(residual_share(both, 41, 0.05), 1e-12);
}

constexpr const char* kProgram = "G21 G90 G94 F6000\nG1 X12 Y5\nG2 X20 Y5 I4 J0\nG4 P0.2\nG1 X3 Y1\nM2\n";

/// Axes that are limited, of which X and Y ring.
Outcome planned(ShaperKind kind, const char* text = kProgram) {
  auto job = std::make_shared<Job>();
  job->program = std::make_shared<const Reading>(read_text(text, "test.ngc").value());
  const Setup setup = default_setup();
  job->machine = setup.machine;
  job->options = setup.options;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    job->machine.axes[axis] = {.speed = 90, .acceleration = 1500, .jerk = 1e5};
    job->machine.servo[axis].resonance = axis == 0 ? 28 : 41;
    job->machine.servo[axis].resonance_damping = 0.02;
  }
  job->options.corner.rule = CornerRule::stop;
  job->options.corner.tolerance = 1;
  job->options.shaper = kind;
  return run(std::shared_ptr<const Job>(job)).value();
}

Setpoints all_of(Sampler sampler) {
  Setpoints rows;
  EXPECT_TRUE(sampler.next(rows, sampler.rows()));
  return rows;
}

TEST(Sampler, ShapedRowsAreMeansOfTheMotion) {
  const Outcome outcome = planned(ShaperKind::ei);
  const Impulses impulses = impulses_of(outcome);
  const Setpoints rows = all_of(sampler_of(outcome));
  EXPECT_EQ(rows.size(), row_count(outcome.plan.cycle_time() + duration_of(impulses), rows.period));
  Motion motion(*outcome.path, outcome.plan);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    AxisVector mean = AxisVector::Zero();
    for (const Impulse& i : impulses) mean += i.share * motion.at(rows.time(k) - i.time).position();
    EXPECT_NEAR(rows.position[0][k], mean[0], 1e-12);
    EXPECT_NEAR(rows.position[1][k], mean[1], 1e-12);
  }
  EXPECT_EQ(rows.position[0].back(), 3);
  EXPECT_EQ(rows.position[1].back(), 1);
  EXPECT_EQ(rows.speed.back(), 0);
}

TEST(Sampler, ShapedRowsKeepEveryLimitAndTheTolerance) {
  for (const ShaperKind kind : kShaperKinds) {
    const auto report = prove(planned(kind));
    ASSERT_TRUE(report) << report.error().message;
    for (const Check& check : report->checks)
      EXPECT_FALSE(check.broken) << shaper_name(kind) << ": " << check_title(check) << " " << check.value << " of "
                                 << check.limit;
  }
}

TEST(Sampler, ShapedRowsOfALineStayOnIt) {
  const Setpoints rows = all_of(sampler_of(planned(ShaperKind::zvd, "G21 G90 G94 F6000\nG1 X12 Y5\nM2\n")));
  for (std::size_t k = 0; k < rows.size(); ++k) EXPECT_NEAR(rows.position[1][k], rows.position[0][k] * 5 / 12, 1e-13);
}

// Singhose, Seering, Singer 1994: undamped, for 5 % of the vibration ZV is 0.06 wide, ZVD 0.29, EI 0.40.
TEST(Shaper, LeavesLittleWithinItsBand) {
  for (const auto& [kind, width] :
       {std::pair(ShaperKind::zv, 0.0637), {ShaperKind::zvd, 0.287}, {ShaperKind::ei, 0.398}}) {
    const Impulses impulses = shaper_for(kind, 25, 0);
    const ShaperBand band = shaper_band(impulses, 25, 0, 0.05);
    EXPECT_NEAR(band.high - band.low, width, 0.002) << shaper_name(kind);
    for (const double edge : {band.low, band.high}) EXPECT_NEAR(residual_share(impulses, 25 * edge, 0), 0.05, 1e-6);
  }
  const ShaperBand none = shaper_band({{0, 1}}, 25, 0, 0.05);
  EXPECT_EQ(none.low, 1);
  EXPECT_EQ(none.high, 1);
}

Vibration vibration_of(const Outcome& o, const Impulses& impulses) {
  return vibration(*o.path, o.plan, o.node_time, o.job->machine.servo, impulses).value();
}

TEST(Vibration, OfShapedMotionIsGoneAfterEachStop) {
  const Outcome outcome = planned(ShaperKind::zv);
  const Vibration hard = vibration_of(outcome, {{0, 1}}), calm = vibration_of(outcome, impulses_of(outcome));
  for (std::size_t axis = 0; axis < 2; ++axis) {
    EXPECT_GT(hard[axis]->residual, 1e-4);
    EXPECT_LT(calm[axis]->peak, hard[axis]->peak);
  }
  // Blocks without a stop in between, and so nothing that begins before the last echo is over.
  const Outcome one = planned(ShaperKind::zv, "G21 G90 G94 F6000\nG1 X12 Y5\nM2\n");
  const double deflection = 1500 / std::pow(2 * std::numbers::pi * 28, 2);
  for (const auto& axis : vibration_of(one, impulses_of(one))) {
    if (!axis) continue;
    EXPECT_LT(axis->residual, 1e-9 * deflection);
  }
}

// The answer of an undamped mode is linear: what a shaper leaves of it is its share, whatever the move.
TEST(Vibration, OfShapedMotionIsTheShapersShareOfIt) {
  Outcome outcome = planned(ShaperKind::none, "G21 G90 G94 F3000\nG1 X7\nM2\n");
  auto servo = outcome.job->machine.servo;
  servo[0].resonance_damping = 0;
  servo[1].resonance = 0;
  const auto left = [&](const Impulses& impulses) {
    return vibration(*outcome.path, outcome.plan, outcome.node_time, servo, impulses).value()[0]->residual;
  };
  for (const ShaperKind kind : kShaperKinds) {
    const Impulses impulses = shaper_for(kind, 33, 0);  // not the mode's frequency
    EXPECT_NEAR(left(impulses), left({{0, 1}}) * residual_share(impulses, 28, 0), 1e-9 * left({{0, 1}}));
  }
}

}  // namespace
}  // namespace toolpace
