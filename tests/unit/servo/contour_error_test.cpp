#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "toolpace/servo/servo_simulation.h"

namespace toolpace {
namespace {

constexpr double kPi = std::numbers::pi;

Setpoints empty_setpoints(double period) {
  Setpoints s;
  s.period = period;
  return s;
}

void add(Setpoints& s, double x, double y, std::uint32_t line = 1) {
  s.position[0].push_back(x);
  s.position[1].push_back(y);
  s.position[2].push_back(0);
  for (auto* column : {&s.speed, &s.acceleration, &s.jerk}) column->push_back(0);
  s.line.push_back(line);
}

ServoMachine all(const ServoAxis& axis) {
  ServoMachine machine;
  machine.fill(axis);
  return machine;
}

TEST(ContourError, OfACircleIsTheLossOfAmplitude) {
  // At constant speed the actual path is a circle of radius R·|G(jΩ)|, Ω = v/R.
  const double radius = 20, speed = 100, period = 1e-4;
  Setpoints s = empty_setpoints(period);
  for (int k = 0; k < 60000; ++k) {
    const double angle = speed / radius * k * period;
    add(s, radius * std::cos(angle), radius * std::sin(angle));
  }
  const ServoAxis axis{.position_gain = 40, .bandwidth = 50};
  const auto result = simulate_servo(s, all(axis)).value();
  const std::complex<double> j(0, speed / radius);
  const double n = 2 * kPi * axis.bandwidth;
  const auto g = 40.0 * n * n / (j * j * j + 2 * axis.damping * n * j * j + n * n * j + 40.0 * n * n);
  const double expected = radius * std::abs(1 - std::abs(g));
  EXPECT_NEAR(result.trace.contour_error[50000], expected, 1e-5 * expected + 1e-6);
  EXPECT_NEAR(result.trace.lag[50000], radius * std::abs(1.0 - g), 1e-4);
}

TEST(ContourError, OfALineIsNoneWhateverTheLag) {
  Setpoints s = empty_setpoints(0.001);
  for (int k = 0; k < 2000; ++k) add(s, 0.08 * k, 0.06 * k);
  const auto result = simulate_servo(s, all({})).value();
  EXPECT_NEAR(result.trace.lag.back(), 2.0, 1e-6);
  EXPECT_LT(result.summary.max_contour_error, 1e-9);
}

TEST(ContourError, OfUnequalGainsOnALineIsKnown) {
  // Lags v/Kx and v/Ky along 45°: the distance from the line is |lag_x − lag_y|/√2.
  Setpoints s = empty_setpoints(0.001);
  for (int k = 0; k < 3000; ++k) add(s, 0.05 * k, 0.05 * k);
  ServoMachine machine;
  machine[0].position_gain = 40;
  machine[1].position_gain = 50;
  const auto result = simulate_servo(s, machine).value();
  EXPECT_NEAR(result.trace.contour_error.back(), (50.0 / 40 - 50.0 / 50) / std::sqrt(2.0), 1e-6);
}

TEST(ContourError, IsTheNearestOfAllDistances) {
  // Against brute force over every chord, on a random zigzag.
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  Setpoints s = empty_setpoints(0.001);
  double x = 0, y = 0, direction = 0;
  for (int k = 0; k < 3000; ++k) {
    if (k % 40 == 0) direction = std::clamp(normal(random), -1.2, 1.2);  // never back: no other stroke passes by
    add(s, x += 0.1 * std::cos(direction), y += 0.1 * std::sin(direction));
  }
  const auto result = simulate_servo(s, all({})).value();
  for (std::size_t k = 0; k < s.size(); k += 7) {
    double best = 1e9;
    const Eigen::Vector2d p(result.trace.actual[0][k], result.trace.actual[1][k]);
    // Four lags of path, 0.1 mm a row, on either side.
    const auto window = static_cast<std::size_t>(4 * result.trace.lag[k] / 0.1);
    const std::size_t from = k > window ? k - window : 0, to = std::min({s.size() - 1, k + window, k + 63});
    for (std::size_t i = from; i < to; ++i) {
      const Eigen::Vector2d a(s.position[0][i], s.position[1][i]), b(s.position[0][i + 1], s.position[1][i + 1]);
      const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
      best = std::min(best, (p - a - t * (b - a)).norm());
    }
    ASSERT_NEAR(result.trace.contour_error[k], std::min(best, result.trace.lag[k]), 1e-12) << "row " << k;
  }
}

// An hour at rest and an hour of creeping, behind a rapid with a lag of millimetres: rows cost the same however many stand at
// one place. (Looking through all of them for each would not end.)
TEST(ContourError, DoesNotGrowWithDwellsAndSlowMotion) {
  auto simulation = ServoSimulation::create(all({}), 0.001).value();
  ServoTrace trace;
  double x = 0;
  std::uint64_t row = 0;
  const auto run = [&](double speed, int rows) {
    Setpoints chunk = empty_setpoints(0.001);
    chunk.first_row = row;
    for (int k = 0; k < rows; ++k) add(chunk, x += speed * 0.001, 0);
    row += static_cast<std::uint64_t>(rows);
    simulation.take(chunk, trace);
  };
  run(300, 1000);
  for (int k = 0; k < 100; ++k) run(0, 10000);
  for (int k = 0; k < 100; ++k) run(0.01, 10000);
  run(300, 1000);
  const ServoSummary summary = simulation.finish(trace);
  EXPECT_EQ(summary.rows, row);
  EXPECT_LT(summary.max_contour_error, 1e-9);
  EXPECT_NEAR(summary.max_lag, 300.0 / 50, 0.5);
}

TEST(ServoSimulation, IsTheSameWhateverTheChunks) {
  Setpoints whole = empty_setpoints(0.001);
  for (int k = 0; k < 5000; ++k)
    add(whole, 20 * std::sin(k / 200.0), 10 * std::cos(k / 130.0), static_cast<std::uint32_t>(k / 100));
  const auto expected = simulate_servo(whole, all({})).value();
  auto simulation = ServoSimulation::create(all({}), 0.001).value();
  ServoTrace trace;
  for (std::size_t first = 0; first < 5000; first += 77) {
    Setpoints chunk = empty_setpoints(0.001);
    chunk.first_row = first;
    for (std::size_t k = first; k < std::min<std::size_t>(first + 77, 5000); ++k) {
      add(chunk, whole.position[0][k], whole.position[1][k], whole.line[k]);
    }
    simulation.take(chunk, trace);
  }
  const ServoSummary summary = simulation.finish(trace);
  EXPECT_EQ(trace.contour_error, expected.trace.contour_error);
  EXPECT_EQ(trace.actual[1], expected.trace.actual[1]);
  EXPECT_EQ(summary.worst_row, expected.summary.worst_row);
  EXPECT_EQ(summary.worst_line, expected.summary.worst_row / 100);
  EXPECT_EQ(summary.max_contour_error, expected.trace.contour_error[summary.worst_row]);
}

TEST(ServoSimulation, TellsHowLongItSettles) {
  // 2 mm of lag at the stop die away as e^(−Kv·t) for a fast drive: ln(2/0.001)/50 = 0.152 s.
  Setpoints s = empty_setpoints(0.001);
  for (int k = 0; k <= 1000; ++k) add(s, 0.1 * k, 0);
  const auto result = simulate_servo(s, all({.bandwidth = 1000})).value();
  EXPECT_NEAR(result.summary.settling_time, std::log(2 / 0.001) / 50, 0.005);
}

}  // namespace
}  // namespace toolpace
