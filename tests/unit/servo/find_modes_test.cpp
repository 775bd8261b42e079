/// Modes found again in recordings that are made of them.

#include "toolpace/servo/find_modes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "toolpace/servo/axis_servo.h"

namespace toolpace {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRate = 3200;

std::vector<double> noise(std::size_t rows, double rms, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, rms);
  std::vector<double> samples(rows);
  for (double& s : samples) s = normal(random);
  return samples;
}

/// A tap at 0.3 s.
std::vector<double> tapped(const std::vector<AxisMode>& modes, unsigned seed) {
  std::vector<double> samples = noise(32000, 20, seed);
  for (std::size_t i = 960; i < samples.size(); ++i) {
    const double t = (static_cast<double>(i) - 960) / kRate;
    for (const AxisMode& m : modes) {
      const double w = 2 * kPi * m.frequency;
      samples[i] +=
          3000 * m.share * std::exp(-m.damping * w * t) * std::cos(w * std::sqrt(1 - m.damping * m.damping) * t);
    }
  }
  return samples;
}

/// The acceleration of a slide whose drive is shaken by noise: a drive that follows its command, and its modes.
std::vector<double> shaken(const std::vector<AxisMode>& modes, unsigned seed) {
  ServoAxis axis;
  axis.position_gain = 5e4;
  axis.velocity_feed_forward = axis.acceleration_feed_forward = 1;
  axis.bandwidth = 1e5;
  axis.damping = 1;
  axis.modes = modes;
  AxisServo servo = AxisServo::create(axis, 1 / kRate).value();
  servo.reset(0);
  const std::vector<double> accelerations = noise(70000, 500, seed);
  std::vector<double> slide, samples;
  double before = 0, from = 0, speed = 0;
  for (const double a : accelerations) {
    speed = (speed + a / kRate) * 0.9999;
    const double to = from * 0.9999 + speed / kRate;
    slide.push_back(servo.step(before, from, to));
    before = from, from = to;
  }
  for (std::size_t i = 5001; i + 1 < slide.size(); ++i)
    samples.push_back((slide[i + 1] - 2 * slide[i] + slide[i - 1]) * kRate * kRate);
  return samples;
}

const std::vector<AxisMode> kTwo = {{31.5, 0.02, 1}, {84, 0.03, 0.4}};

// What 40 seeds gave: frequencies off by 0.012 % and 0.48 % at most, dampings by 1.0 % and 15 %. The second is no scatter but a bias
// (-12.9 %, always to the same side, within the error that is told, 10 %): the peak of a tap is not quite the one that is fitted,
// and the flank of the stronger mode lies below it.
TEST(FindModes, InARingDown) {
  const double frequency_bound[] = {3e-4, 0.006}, damping_bound[] = {0.02, 0.16};
  for (const unsigned seed : {1u, 2u, 3u}) {
    const auto found = find_modes(tapped(kTwo, seed), 1 / kRate);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->modes.size(), 2u) << seed;
    for (std::size_t i = 0; i < 2; ++i) {
      const FoundMode& m = found->modes[i];
      EXPECT_NEAR(m.mode.frequency, kTwo[i].frequency, frequency_bound[i] * kTwo[i].frequency) << seed;
      EXPECT_NEAR(m.mode.damping, kTwo[i].damping, damping_bound[i] * kTwo[i].damping) << seed;
      EXPECT_LT(std::abs(m.mode.damping - kTwo[i].damping), 3 * m.damping_error) << seed;
    }
  }
}

// 20 s of noise tell no more: over 40 seeds the frequencies scatter by 0.46 % and 0.69 % (the errors that are told: 0.43 %, 0.44 %), the
// dampings by 25 % and 15 % (21 %, 15 %). The bounds below are three of these for frequencies, two and more for dampings.
TEST(FindModes, OfAnAxisThatIsShakenAndTheirSpreads) {
  int inside = 0, all = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const auto found = find_modes(shaken(kTwo, seed), 1 / kRate);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->modes.size(), 2u) << seed;
    for (std::size_t i = 0; i < 2; ++i) {
      const FoundMode& m = found->modes[i];
      EXPECT_NEAR(m.mode.frequency, kTwo[i].frequency, 0.02 * kTwo[i].frequency) << seed;
      EXPECT_NEAR(m.mode.damping, kTwo[i].damping, 0.5 * kTwo[i].damping) << seed;
      inside += std::abs(m.mode.frequency - kTwo[i].frequency) < 3 * m.frequency_error;
      inside += std::abs(m.mode.damping - kTwo[i].damping) < 3 * m.damping_error;
      all += 2;
    }
    EXPECT_NEAR(found->modes[1].mode.share, 0.4, 0.15) << seed;
  }
  EXPECT_GE(inside, all - 1);
}

TEST(FindModes, InNoiseAloneThereAreNone) {
  for (const unsigned seed : {1u, 2u, 3u, 4u})
    EXPECT_TRUE(find_modes(noise(32000, 50, seed), 1 / kRate)->modes.empty());
}

TEST(FindModes, AHummingFanIsNoMode) {
  std::vector<double> samples = tapped({{31.5, 0.02, 1}}, 5);
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i] += 200 * std::sin(2 * kPi * 120 * static_cast<double>(i) / kRate);
  const auto found = find_modes(samples, 1 / kRate);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->modes.size(), 1u);
  ASSERT_EQ(found->tones.size(), 1u);
  EXPECT_NEAR(found->tones[0], 120, 0.1);
}

TEST(FindModes, SaysWhatIsWrongWithARecording) {
  EXPECT_EQ(find_modes(std::vector<double>(2000, 9806.65), 1 / kRate).error().code, "accelerometer-still");
  std::vector<double> cut = tapped(kTwo, 7);
  for (double& s : cut) s = std::clamp(s, -1500.0, 1500.0);
  EXPECT_EQ(find_modes(cut, 1 / kRate).error().code, "accelerometer-saturated");
  // One that counts in coarse steps is not saturated.
  std::vector<double> coarse = tapped(kTwo, 7);
  for (double& s : coarse) s = 40 * std::round(s / 40);
  EXPECT_TRUE(find_modes(coarse, 1 / kRate));
}

TEST(FindModes, WelchsPowerIsThatOfTheSamples) {
  const std::vector<double> samples = noise(1 << 14, 3, 1);
  const PowerSpectrum s = power_spectrum(samples, 1 / kRate, 1024);
  double sum = 0;
  for (const double p : s.power) sum += p * s.resolution;
  EXPECT_NEAR(sum, 9, 0.3);
  EXPECT_DOUBLE_EQ(s.resolution, kRate / 1024);
}

}  // namespace
}  // namespace toolpace
