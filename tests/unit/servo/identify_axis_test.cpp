/// Round trips: what a drive with known values did is given, with noise, and its values are asked for.

#include "toolpace/servo/identify_axis.h"
#include "toolpace/servo/servo_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "case_count.h"
#include "noisy_axis.h"

namespace toolpace {
namespace {

constexpr double kNoise = 0.0005;      // [mm]
constexpr std::size_t kRows = 12'000;  // 12 s at 1 kHz

std::array<double, 8> values_of(const ServoAxis& a) {
  return {a.position_gain, a.velocity_feed_forward, a.acceleration_feed_forward, a.bandwidth, a.damping, a.backlash,
          a.resonance,     a.resonance_damping};
}

TEST(Identification, FindsADriveAgainInNoisyTraces) {
  const auto count = static_cast<int>(test::case_count(1));
  std::array<int, 8> inside = {}, close = {};
  for (int seed = 1; seed <= count; ++seed) {
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    const ServoAxis drive = test::random_drive(random);
    const auto found = identify_axis(test::noisy_axis(drive, random, kRows, kNoise), {});
    ASSERT_TRUE(found) << seed << found.error().message;
    const auto truth = values_of(drive);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const IdentifiedValue& v = found->values[i];
      EXPECT_TRUE(v.is_told) << seed << kIdentifiedNames[i];
      inside[i] += std::abs(v.value - truth[i]) <= 3 * v.error;
    }
    close[0] += std::abs(found->values[0].value / truth[0] - 1) < 0.01;
    close[5] += std::abs(found->values[5].value - truth[5]) < 0.001;
    close[6] += std::abs(found->values[6].value / truth[6] - 1) < 0.005;
    EXPECT_NEAR(found->noise, kNoise, 0.1 * kNoise) << seed;
  }
  for (std::size_t i = 0; i < inside.size(); ++i) EXPECT_GE(inside[i], 0.95 * count) << kIdentifiedNames[i];
  for (const std::size_t i : {0u, 5u, 6u}) EXPECT_GE(close[i], 0.95 * count) << kIdentifiedNames[i];
}

TEST(Identification, OfAStiffDriveWithoutPlayFindsNeither) {
  std::mt19937_64 random(3);
  ServoAxis drive = test::random_drive(random);
  drive.backlash = drive.resonance = 0;
  const auto found = identify_axis(test::noisy_axis(drive, random, kRows, kNoise), {});
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_TRUE(found->values[5].is_told);
  EXPECT_EQ(found->values[5].value, 0);
  EXPECT_GT(found->values[5].error, 0);
  EXPECT_LT(found->values[5].error, 0.001);
  EXPECT_FALSE(found->values[6].is_told);
  EXPECT_STREQ(found->values[6].verdict, "no resonance shows in the trace");
  EXPECT_NEAR(found->values[0].value, drive.position_gain, 3 * found->values[0].error);
  EXPECT_EQ(found->axis.resonance, 0);
}

TEST(Identification, OfAnAxisThatNeverTurnsBackTellsNoBacklash) {
  std::mt19937_64 random(4);
  ServoAxis drive = test::random_drive(random);
  drive.backlash = 0;
  auto data = test::noisy_axis(drive, random, 4000, 0);
  // The same moves, all in one direction.
  auto servo = AxisServo::create(drive, data.period).value();
  double sum = 0, before = 0, from = 0;
  const auto moves = data.commanded;
  for (std::size_t k = 1; k < moves.size(); ++k) {
    sum += std::abs(moves[k] - moves[k - 1]);
    data.commanded[k] = sum;
    data.actual[k] = servo.step(before, from, sum);
    before = from;
    from = sum;
  }
  ServoAxis known;
  known.backlash = 0.02;
  const auto found = identify_axis(data, known);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_FALSE(found->values[5].is_told);
  EXPECT_STREQ(found->values[5].verdict, "the axis never turns back");
  EXPECT_EQ(found->axis.backlash, 0.02);
}

TEST(Identification, FindsTheClockWhereNothingIsKnownOfIt) {
  std::mt19937_64 random(5);
  const ServoAxis drive = test::random_drive(random);
  auto data = test::noisy_axis(drive, random, kRows, kNoise);
  for (double& t : data.time) t -= 0.0123;
  data.clock_error.reset();
  const auto found = identify_axis(data, {});
  ASSERT_TRUE(found) << found.error().message;
  // A clock and a lag are nearly the same to a trace: both are told less well than where the clock is known.
  EXPECT_NEAR(found->clock, 0.0123, 0.001);
  EXPECT_NEAR(found->values[0].value, drive.position_gain, 0.03 * drive.position_gain);
  EXPECT_NEAR(found->values[6].value, drive.resonance, 0.005 * drive.resonance);
}

TEST(Identification, RefusesWhatNoDriveDoes) {
  std::mt19937_64 random(6);
  auto data = test::noisy_axis(test::random_drive(random), random, 4000, 0);
  for (std::size_t k = 0; k < data.actual.size(); ++k) data.actual[k] += 2 * std::sin(static_cast<double>(k * k % 977));
  const auto odd = identify_axis(data, {});
  ASSERT_FALSE(odd);
  EXPECT_EQ(odd.error().code, "identify-no-fit");
  std::fill(data.commanded.begin(), data.commanded.end(), 1.0);
  const auto still = identify_axis(data, {});
  ASSERT_FALSE(still);
  EXPECT_EQ(still.error().code, "identify-still");
}

// All that is free lies at the end of its range, and the trace asks for more.
TEST(ServoFit, StaysWhereEverythingIsHeld) {
  detail::FitData data;
  for (int k = 0; k < 200; ++k) data.commanded.push_back(5 * (1 - std::cos(0.05 * k)));
  for (std::size_t k = 0; k < data.commanded.size(); ++k) data.time.push_back(static_cast<double>(k) * data.period);
  detail::FitState state;
  state.axis.velocity_feed_forward = -0.2;
  data.actual = detail::ServoFit(data).model(state);
  state.axis.velocity_feed_forward = 0;
  state.free[detail::kVelocityForward] = true;
  const detail::FitResult found = detail::ServoFit(data).fit(state, 20);
  EXPECT_TRUE(found.has_converged);
  EXPECT_EQ(found.state.axis.velocity_feed_forward, 0);
  EXPECT_GT(found.squares, 0);
}

}  // namespace
}  // namespace toolpace
