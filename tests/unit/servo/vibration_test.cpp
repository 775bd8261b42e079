/// Vibration against closed forms, and against the simulation of the drives.

#include "toolpace/servo/vibration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "toolpace/law/single_move.h"
#include "toolpace/servo/axis_modes.h"
#include "toolpace/servo/axis_servo.h"
#include "toolpace/servo/mode.h"

namespace toolpace {
namespace {

constexpr double kPi = std::numbers::pi;

struct Case {
  LawKind law;
  double length, feed;
  Dynamics dynamics;
};

SingleMove move_of(const Case& c) { return single_move(c.law, {c.length, c.feed, 0, 0}, c.dynamics).value(); }

Dynamics dynamics_of(double acceleration, double jerk, double time = 0) {
  return {{acceleration, jerk, time}, {acceleration, jerk, time}};
}

Mode shaken(const SingleMove& move, double frequency, double damping) {
  Mode mode(frequency, damping);
  for (const Phase& phase : move.phases.span()) mode.run(acceleration_of(phase), phase.duration);
  return mode;
}

/// Of an axis with this mode alone.
AxisModes modes_with(double frequency, double damping) {
  ServoAxis axis;
  axis.modes = {{frequency, damping, 1.0}};
  return AxisModes(axis);
}

double peak_of(const SingleMove& move, double frequency, double damping) {
  AxisModes modes = modes_with(frequency, damping);
  for (const Phase& phase : move.phases.span()) modes.run(acceleration_of(phase), phase.duration);
  return modes.peak();
}

double sinc(double x) { return x == 0 ? 1 : std::sin(x) / x; }

/// Up and down again, the ramps of one form that are `apart` in time: |A(jω)| = v·|form(ω)|·2·|sin(ω·apart/2)|.
double pair_of(double v, double form, double omega, double apart) {
  return std::abs(v * form * 2 * std::sin(omega * apart / 2));
}

/// ∫₀¹ 30u²(1−u)²·e^(−jxu) du = 60·j₂(x/2)/x², j₂ the spherical Bessel function.
double quintic_form(double x) {
  const double z = x / 2;
  const double j2 = (3 / (z * z * z) - 1 / z) * std::sin(z) - 3 / (z * z) * std::cos(z);
  return 60 * j2 / (x * x);
}

TEST(Vibration, OfFivePhaseRampsThatLastTwoPeriodsLeavesNothing) {
  // The acceleration is a triangle of width Tacc, whose spectrum sinc²(ω·Tacc/4) vanishes at ω = 4π/Tacc.
  for (const double f : {7.0, 23.0, 60.0}) {
    const double time = 2 / f, feed = 80, highest = 2 * feed / time;
    const auto move = move_of({LawKind::five_phase_time, 50, feed, dynamics_of(1e6, 1e12, time)});
    const double deflection = highest / std::pow(2 * kPi * f, 2);
    EXPECT_LT(shaken(move, f, 0).amplitude(), 1e-9 * deflection) << f;
    EXPECT_GT(peak_of(move, f, 0), 0.5 * deflection) << f;
    // Half as long, and it is as large as can be.
    const auto hard = move_of({LawKind::five_phase_time, 50, feed, dynamics_of(1e6, 1e12, 0.5 * time)});
    EXPECT_GT(shaken(hard, f, 0).amplitude(), 0.01 * deflection) << f;
  }
}

TEST(Vibration, HasTheSpectrumsOfTheLawsInClosedForm) {
  const double v = 60, length = 40, a = 2000, jerk = 8e4;
  for (const double f : {0.01, 0.7, 3.0, 11.0, 47.0, 310.0}) {
    const double w = 2 * kPi * f;
    const double scale = 2 * v;  // ∫|a|dt
    const auto check = [&](LawKind law, const Dynamics& d, double ramp, double form) {
      const auto move = move_of({law, length, v, d});
      const double apart = move.total_time() - ramp;
      const double found = std::abs(acceleration_spectrum(move.phases.span(), w));
      EXPECT_NEAR(found, pair_of(v, form, w, apart), 1e-10 * scale) << static_cast<int>(law) << ' ' << f;
      EXPECT_NEAR(shaken(move, f, 0).amplitude() * w, found, 1e-10 * scale * std::max(1.0, w * move.total_time()))
          << static_cast<int>(law) << ' ' << f;
    };
    const double t = v / a;
    check(LawKind::trapezoid, dynamics_of(a, 1e12), t, sinc(w * t / 2));
    check(LawKind::five_phase_time, dynamics_of(a, 1e12, 0.08), 0.08, std::pow(sinc(w * 0.08 / 4), 2));
    const double of_jerk = a / jerk;  // the acceleration rises in it; a trapezoid is a rectangle smoothed by another
    check(LawKind::seven_phase, dynamics_of(a, jerk), t + of_jerk, sinc(w * t / 2) * sinc(w * of_jerk / 2));
    const auto quintic = move_of({LawKind::quintic, length, v, dynamics_of(a, jerk)});
    check(LawKind::quintic, dynamics_of(a, jerk), quintic.up.time,
          w * quintic.up.time > 0.2
              ? quintic_form(w * quintic.up.time)
              : 1 - std::pow(w * quintic.up.time, 2) / 56 + std::pow(w * quintic.up.time, 4) / 8064);
  }
}

TEST(Vibration, OfADampedModeDecaysAsItMust) {
  AxisModes mode = modes_with(20, 0.1);
  mode.step(-2 * kPi * 20);  // ḋ = ω
  const double w = 2 * kPi * 20, damped = w * std::sqrt(1 - 0.01);
  mode.run({}, 0.3);
  EXPECT_NEAR(mode.displacement(), w / damped * std::exp(-0.1 * w * 0.3) * std::sin(damped * 0.3), 1e-12);
  const double first = std::acos(0.1) / damped;  // where ḋ = 0
  EXPECT_NEAR(mode.peak(), w / damped * std::exp(-0.1 * w * first) * std::sin(damped * first), 1e-12);
  EXPECT_NEAR(mode.peak_time(), first, 1e-9);
}

TEST(Vibration, OfShortAndLongPiecesIsTheSame) {
  const AccelerationPolynomial a = {100, -300, 4000, 2e4, -1e5, 3e5};
  for (const double damping : {0.0, 0.3, 1.0, 4.0}) {
    AxisModes whole = modes_with(9, damping), parts = whole;
    whole.run(a, 0.2);
    for (int k = 0; k < 400; ++k) {
      // The same polynomial about the begin of the part, by Horner's shifts.
      AccelerationPolynomial c = a;
      const double at = 0.0005 * k;
      for (std::size_t i = 0; i + 1 < c.size(); ++i) {
        for (std::size_t j = c.size() - 1; j-- > i;) c[j] += at * c[j + 1];
      }
      parts.run(c, 0.0005);
    }
    EXPECT_NEAR(parts.displacement(), whole.displacement(), 1e-11) << damping;
    EXPECT_NEAR(parts.amplitude(), whole.amplitude(), 1e-11) << damping;
    EXPECT_NEAR(parts.peak(), whole.peak(), 1e-11) << damping;
  }
}

TEST(Vibration, AgreesWithTheSimulationOfTheSameModes) {
  // A drive that follows its command to 1e-9 mm, and setpoints every microsecond: what is left are the modes.
  ServoAxis axis;
  axis.position_gain = 5e4;
  axis.velocity_feed_forward = axis.acceleration_feed_forward = 1;
  axis.bandwidth = 1e5;
  axis.damping = 1;
  axis.resonance = 31;
  axis.resonance_damping = 0.03;
  axis.modes = {{72, 0.02, 0.5}};
  const double period = 1e-6;
  auto servo = AxisServo::create(axis, period).value();
  servo.reset(0);
  const auto move = move_of({LawKind::seven_phase, 5, 60, dynamics_of(2000, 2e5)});
  AxisModes modes(axis);
  double before = 0, from = 0, worst = 0, largest = 0;
  std::size_t k = 0;
  double begin = 0;
  for (const Phase& phase : move.phases.span()) {
    for (; static_cast<double>(k) * period <= begin + phase.duration; ++k) {
      const double t = static_cast<double>(k) * period - begin;
      const double to = evaluate(phase, t).distance;
      const double slide = servo.step(before, from, to);
      before = from, from = to;
      if (k % 500 != 0) continue;
      const double here = modes.displacement(acceleration_of(phase), t);
      worst = std::max(worst, std::abs(slide - to - here));
      largest = std::max(largest, std::abs(here));
    }
    modes.run(acceleration_of(phase), phase.duration);
    begin += phase.duration;
  }
  EXPECT_GT(largest, 0.02);
  EXPECT_LT(worst, 1e-8);
}

TEST(Vibration, OfSeveralModesIsTheSumOfTheirs) {
  ServoAxis both;
  both.resonance = 12;
  both.resonance_damping = 0.01;
  both.modes = {{12.5, 0.01, 0.4}};
  AxisModes modes(both), slow = modes_with(12, 0.01), quick = modes_with(12.5, 0.01);
  for (AxisModes* m : {&modes, &slow, &quick}) m->step(100);
  EXPECT_NEAR(modes.amplitude(), slow.amplitude() + 0.4 * quick.amplitude(), 1e-12);
  double largest = 0;
  for (int k = 0; k < 4000; ++k) {
    for (AxisModes* m : {&modes, &slow, &quick}) m->run({}, 5e-4);
    ASSERT_NEAR(modes.displacement(), slow.displacement() + 0.4 * quick.displacement(), 1e-12);
    largest = std::max(largest, std::abs(modes.displacement()));
  }
  EXPECT_GE(modes.peak(), largest);
  EXPECT_LT(modes.peak(), 1.01 * largest);
}

}  // namespace
}  // namespace toolpace
