/// The drive model against closed forms.

#include "toolpace/servo/axis_servo.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "toolpace/servo/servo_range.h"
#include "toolpace/servo/servo_simulation.h"

namespace toolpace {
namespace {

constexpr double kPi = std::numbers::pi;

AxisServo servo_of(const ServoAxis& axis, double period) {
  auto servo = AxisServo::create(axis, period);
  EXPECT_TRUE(servo) << servo.error().message;
  servo->reset(0);
  return *servo;
}

/// Lag after a long ramp at 100 mm/s.
double ramp_lag(const ServoAxis& axis, double period) {
  AxisServo servo = servo_of(axis, period);
  double lag = 0;
  const double step = 100 * period;
  for (int k = 1; k * period < std::max(3.0, 6 * period); ++k)
    lag = k * step - servo.step((k > 1 ? k - 2 : 0) * step, (k - 1) * step, k * step);
  return lag;
}

/// Frequency response of loop and drive (and resonance) at angular frequency w.
/// y/r = (Kv + kv·s + ka·(2ζ/ω)·s²)·ω² / (s³ + 2ζω·s² + ω²·s + Kv·ω²)
std::complex<double> response(const ServoAxis& a, double w) {
  const std::complex<double> s(0, w);
  const double n = 2 * kPi * a.bandwidth, r = 2 * kPi * a.resonance;
  const auto forward =
      a.position_gain + a.velocity_feed_forward * s + a.acceleration_feed_forward * 2 * a.damping / n * s * s;
  auto h = forward * n * n / (s * s * s + 2 * a.damping * n * s * s + n * n * s + a.position_gain * n * n);
  const auto ring_of = [&](double frequency, double damping) {
    const auto ring = 2 * damping * frequency * s + frequency * frequency;
    return ring / (s * s + ring);
  };
  std::complex<double> slide = 1;  // over the motor: 1 + Σ share·(ring − 1)
  if (a.resonance > 0) slide = ring_of(r, a.resonance_damping);
  for (const AxisMode& m : a.modes) slide += m.share * (ring_of(2 * kPi * m.frequency, m.damping) - 1.0);
  return h * slide;
}

/// Amplitude of the settled answer to sin(w·t).
double simulated_gain(const ServoAxis& axis, double w, double period) {
  AxisServo servo = servo_of(axis, period);
  double before = 0, last = 0, largest = 0;
  const double settled = 4.0, end = settled + 4 * 2 * kPi / w;
  for (int k = 1; k * period < end; ++k) {
    const double next = std::sin(w * k * period);
    const double y = servo.step(before, last, next);
    if (k * period > settled) largest = std::max(largest, std::abs(y));
    before = last;
    last = next;
  }
  return largest;
}

TEST(AxisServo, LagsARampBySpeedOverGain) {
  // v/Kv = 100/50 = 2 mm, whatever the drive; with feed-forward its share is left.
  for (const double period : {0.0001, 0.001, 0.016, 0.25}) {
    EXPECT_NEAR(ramp_lag({}, period), 2.0, 1e-9) << period;
    EXPECT_NEAR(ramp_lag({.velocity_feed_forward = 0.75}, period), 0.5, 1e-9) << period;
    EXPECT_NEAR(ramp_lag({.velocity_feed_forward = 1.0}, period), 0.0, 1e-9) << period;
  }
}

TEST(AxisServo, AnswersASineAsItsTransferFunctionDoes) {
  for (const double hertz : {0.5, 3.0, 11.0}) {
    for (const ServoAxis& axis :
         {ServoAxis{}, ServoAxis{.position_gain = 120, .velocity_feed_forward = 0.9, .acceleration_feed_forward = 0.5},
          ServoAxis{.bandwidth = 30, .damping = 1.2}, ServoAxis{.resonance = 15, .resonance_damping = 0.1},
          ServoAxis{.modes = {{15, 0.1, 0.4}}},
          ServoAxis{.resonance = 20, .resonance_damping = 0.1, .modes = {{9, 0.08, 0.3}, {31, 0.2, 0.7}}}}) {
      const double w = 2 * kPi * hertz;
      // 0.1 ms: the straight pieces between setpoints cost (w·Ts)²/12 of the amplitude, 4e-6 at 11 Hz.
      EXPECT_NEAR(simulated_gain(axis, w, 1e-4), std::abs(response(axis, w)), 3e-4) << hertz << " Hz";
    }
  }
}

TEST(AxisServo, IsExactAtAnyPeriod) {
  // A ramp in steps of 10 ms and of 1 ms is the same command: the answers agree at common times to rounding.
  for (const ServoAxis& axis : {ServoAxis{}, ServoAxis{.resonance = 20}, ServoAxis{.modes = {{9, 0.02, 0.3}, {44}}}}) {
    AxisServo coarse = servo_of(axis, 0.010), fine = servo_of(axis, 0.001);
    for (int k = 0; k < 50; ++k) {
      const double slow = coarse.step(std::max(0, k - 1), k, k + 1);
      double quick = 0;
      for (int i = 0; i < 10; ++i) quick = fine.step(k + (i - 1) / 10.0, k + i / 10.0, k + (i + 1) / 10.0);
      ASSERT_NEAR(slow, quick, 1e-9) << k;
    }
  }
}

TEST(AxisServo, StaysExactFarFromZero) {
  AxisServo near = servo_of({}, 0.001), far = servo_of({}, 0.001);
  far.reset(1e6);
  for (int k = 0; k < 1000; ++k) {
    const auto at = [&](int i) { return i < 0 ? 0.0 : 0.0625 * i; };
    ASSERT_NEAR(near.step(at(k - 1), at(k), at(k + 1)), far.step(1e6 + at(k - 1), 1e6 + at(k), 1e6 + at(k + 1)) - 1e6,
                1e-8);
  }
}

TEST(AxisServo, LosesItsPlayAtReversals) {
  const ServoAxis axis{.position_gain = 200, .backlash = 0.02};
  AxisServo servo = servo_of(axis, 0.001);
  // Slowly up by 1 mm, then down: the slide stands half the play behind, on either side.
  double up = 0, down = 0;
  for (int k = 0; k < 100000; ++k) up = servo.step(std::max(0, k - 1) * 1e-5, k * 1e-5, (k + 1) * 1e-5);
  for (int k = 100000; k > 50000; --k) down = servo.step((k + 1) * 1e-5, k * 1e-5, (k - 1) * 1e-5);
  const double lag = 0.01 / 200;  // v/Kv
  EXPECT_NEAR(up, 1.0 - lag - 0.01, 1e-5);
  EXPECT_NEAR(down, 0.5 + lag + 0.01, 2e-5);
}

TEST(AxisServo, RingsBehindItsPlayToo) {
  const ServoAxis stiff{.backlash = 0.02}, soft{.backlash = 0.02, .resonance = 12, .resonance_damping = 0.05};
  AxisServo a = servo_of(stiff, 0.001), b = servo_of(soft, 0.001);
  double furthest = 0, end_a = 0, end_b = 0;
  for (int k = 0; k < 3000; ++k) {
    const auto at = [](int i) { return std::clamp(i, 0, 100) * 0.1; };  // 10 mm in 0.1 s, then a stop
    end_a = a.step(at(k - 1), at(k), at(k + 1));
    end_b = b.step(at(k - 1), at(k), at(k + 1));
    furthest = std::max(furthest, end_b);
  }
  EXPECT_GT(furthest, end_a + 0.05);  // it swings past
  EXPECT_NEAR(end_b, end_a, 1e-4);    // and comes to rest at the same place
}

TEST(AxisServo, RingsInAModeOfShareOneAsInItsResonance) {
  for (const double play : {0.0, 0.02}) {
    AxisServo one = servo_of({.backlash = play, .resonance = 12, .resonance_damping = 0.03}, 0.001);
    AxisServo other = servo_of({.backlash = play, .modes = {{12, 0.03, 1}}}, 0.001);
    // Two halves of one mode are that mode.
    AxisServo halves = servo_of({.backlash = play, .modes = {{12, 0.03, 0.5}, {12, 0.03, 0.5}}}, 0.001);
    for (int k = 0; k < 500; ++k) {
      const auto at = [](int i) { return std::clamp(i, 0, 100) * 0.1; };
      const double place = one.step(at(k - 1), at(k), at(k + 1));
      ASSERT_EQ(other.step(at(k - 1), at(k), at(k + 1)), place) << k;
      ASSERT_NEAR(halves.step(at(k - 1), at(k), at(k + 1)), place, 1e-12) << k;
    }
  }
}

// The lag behind a ramp is v/Kv whatever the drive; at 1e18 Hz it came out as 100 mm.
TEST(AxisServo, IsTrueAtTheEndsOfTheRangesItTakes) {
  for (const double damping : {kServoDamping.least, 0.7, kServoDamping.most}) {
    for (const double period : {1e-5, 1e-3, 0.1, 10.0}) {
      const ServoAxis fast = {.bandwidth = kServoBandwidth.most, .damping = damping};
      const double rounding = 1e-6 + 1e-5 * period;  // of a matrix exponential of 1e5 Hz · period
      EXPECT_NEAR(ramp_lag(fast, period), 2, rounding) << damping << " " << period;
      const ServoAxis ringing = {.resonance = kServoResonance.most, .resonance_damping = damping};
      EXPECT_NEAR(ramp_lag(ringing, period), 2, rounding) << damping << " " << period;
    }
  }
  for (const double beyond : {1e18, 1e-320, 1e5 * 1.001, static_cast<double>(INFINITY)}) {
    EXPECT_EQ(AxisServo::create({.bandwidth = beyond}, 0.001).error().code, "servo-value");
    EXPECT_EQ(AxisServo::create({.position_gain = beyond}, 0.001).error().code, "servo-value");
  }
}

TEST(AxisServo, RefusesWhatWouldSwingUpOrMakesNoSense) {
  const auto unstable = AxisServo::create({.position_gain = 900, .bandwidth = 100, .damping = 0.7}, 0.001);
  ASSERT_FALSE(unstable);
  EXPECT_EQ(unstable.error().code, "servo-unstable");
  EXPECT_NEAR(*unstable.error().attainable, 2 * 0.7 * 2 * kPi * 100, 1e-9);
  EXPECT_EQ(AxisServo::create({.damping = 0}, 0.001).error().code, "servo-value");
  EXPECT_EQ(AxisServo::create({.backlash = -1}, 0.001).error().code, "servo-value");
  EXPECT_EQ(AxisServo::create({}, 0.0).error().code, "servo-value");
  EXPECT_EQ(AxisServo::create({.resonance = NAN}, 0.001).error().code, "servo-value");
  EXPECT_EQ(AxisServo::create({.modes = {{0, 0.05, 1}}}, 0.001).error().code, "servo-value");
  EXPECT_EQ(AxisServo::create({.modes = {{30, 0.05, 2}}}, 0.001).error().code, "servo-value");
}

}  // namespace
}  // namespace toolpace
