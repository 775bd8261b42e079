/// Axis-steps per second: drives alone, and with the contour error of three axes.

#include <benchmark/benchmark.h>

#include <cmath>

#include "toolpace/servo/servo_simulation.h"

namespace {

using namespace toolpace;

constexpr std::size_t kRows = 200000;

Setpoints curve() {
  Setpoints s;
  for (std::size_t k = 0; k < kRows; ++k) {
    const double t = static_cast<double>(k) * s.period;
    s.position[0].push_back(30 * std::sin(3 * t));
    s.position[1].push_back(30 * std::cos(2 * t));
    s.position[2].push_back(5 * std::sin(t));
    for (auto* column : {&s.speed, &s.acceleration, &s.jerk}) column->push_back(0);
    s.line.push_back(1);
  }
  return s;
}

void servo_with_contour_error(benchmark::State& state) {
  const Setpoints s = curve();
  for (auto _ : state) {
    auto result = simulate_servo(s, ServoMachine{});
    benchmark::DoNotOptimize(result);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(3 * kRows));
}
BENCHMARK(servo_with_contour_error)->Unit(benchmark::kMillisecond);

void servo_steps(benchmark::State& state) {
  const Setpoints s = curve();
  AxisServo servo = AxisServo::create(ServoAxis{.resonance = 40}, s.period).value();
  servo.reset(0);
  const auto& x = s.position[0];
  for (auto _ : state) {
    double sum = 0;
    for (std::size_t k = 2; k < kRows; ++k) sum += servo.step(x[k - 2], x[k - 1], x[k]);
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kRows));
}
BENCHMARK(servo_steps)->Unit(benchmark::kMillisecond);

}  // namespace
