/// Single moves: one full profile (peak, phases, ramps, times), the peak speed alone, reach; and stepper pulse tables.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "toolpace/law/single_move.h"
#include "toolpace/sample/pulse_table.h"

namespace {

using namespace toolpace;

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

struct Job {
  MoveRequest move;
  Dynamics dynamics;
};

double log_uniform(std::mt19937_64& random, double low, double high) {
  return low * std::pow(high / low, std::uniform_real_distribution<>(0, 1)(random));
}

/// The limits as a single move of the law has them: five-phase by time knows Tacc and Tdec alone.
template <class Law>
Dynamics limits_of(Dynamics dynamics) {
  if (Law::kKind == LawKind::five_phase_time) {
    dynamics.up.acceleration = dynamics.up.jerk = dynamics.down.acceleration = dynamics.down.jerk = kUnbounded;
  }
  return dynamics;
}

/// Moves with v0, v1 ≠ 0 whose end speed can be reached; every limit differs from move to move.
template <class Law>
std::vector<Job> random_jobs() {
  std::mt19937_64 random(20140301);
  std::uniform_real_distribution<> unit(0, 1);
  std::vector<Job> jobs;
  while (jobs.size() < 4096) {
    const double feed = log_uniform(random, 10, 1000), acceleration = log_uniform(random, 100, 2e4);
    const double jerk = log_uniform(random, 1e4, 1e7), time = log_uniform(random, 1e-3, 0.1);
    Job job{{log_uniform(random, 0.05, 500), feed, feed * unit(random), feed * unit(random)},
            {{acceleration, jerk, time}, {acceleration * (0.5 + unit(random)), jerk * (0.5 + unit(random)), time}}};
    job.dynamics = limits_of<Law>(job.dynamics);
    if (!check_move(Law::kKind, job.move, job.dynamics)) jobs.push_back(job);
  }
  return jobs;
}

template <class Law>
void run(benchmark::State& state, const std::vector<Job>& jobs) {
  std::size_t i = 0;
  for (auto _ : state) {
    const Job& job = jobs[i++ % jobs.size()];
    const auto profile = single_move<Law>(job.move, job.dynamics);
    benchmark::DoNotOptimize(profile->phases.back());
    benchmark::DoNotOptimize(profile->peak);
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()));
  state.SetLabel("profiles");
}

template <class Law>
void single_move_random(benchmark::State& state) {
  run<Law>(state, random_jobs<Law>());
}

/// One move of the kind that a slider moves: both ramps limited by acceleration (or Tacc), with a cruise.
template <class Law>
void single_move_typical(benchmark::State& state) {
  run<Law>(state, {{{40, 100, 10, 20}, limits_of<Law>({{3000, 1e6, 0.035}, {2500, 8e5, 0.02}})}});
}

/// The same, too short to reach the feed.
template <class Law>
void single_move_short(benchmark::State& state) {
  run<Law>(state, {{{3, 200, 30, 20}, limits_of<Law>({{3000, 1e6, 0.015}, {2500, 8e5, 0.012}})}});
}

template <class Law>
void peak_speed_random(benchmark::State& state) {
  const auto jobs = random_jobs<Law>();
  std::size_t i = 0;
  for (auto _ : state) {
    const Job& job = jobs[i++ % jobs.size()];
    benchmark::DoNotOptimize(
        peak_speed<Law>(job.move.start, job.move.end, job.move.feed, job.move.length, job.dynamics));
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()));
  state.SetLabel("peaks");
}

template <class Law>
void reach_random(benchmark::State& state) {
  const auto jobs = random_jobs<Law>();
  std::size_t i = 0;
  for (auto _ : state) {
    const Job& job = jobs[i++ % jobs.size()];
    benchmark::DoNotOptimize(Law::reach(job.move.start, job.move.length, job.dynamics.up));
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()));
  state.SetLabel("speeds");
}

#define TOOLPACE_EVERY_LAW(function)           \
  BENCHMARK_TEMPLATE(function, Trapezoid);     \
  BENCHMARK_TEMPLATE(function, FivePhaseTime); \
  BENCHMARK_TEMPLATE(function, FivePhaseJerk); \
  BENCHMARK_TEMPLATE(function, SevenPhase);    \
  BENCHMARK_TEMPLATE(function, Quintic)

TOOLPACE_EVERY_LAW(single_move_typical);
TOOLPACE_EVERY_LAW(single_move_short);
TOOLPACE_EVERY_LAW(single_move_random);
TOOLPACE_EVERY_LAW(peak_speed_random);
TOOLPACE_EVERY_LAW(reach_random);

/// Pulse intervals in pieces of 8192, as a file is written.
void pulse_table(benchmark::State& state, const StepperMove& move) {
  const auto table = PulseTable::create(move);
  if (!table) return state.SkipWithError(table.error().message.c_str());
  std::vector<std::uint32_t> ticks(8192);
  for (auto _ : state) {
    for (std::uint64_t first = 0; first < move.steps; first += ticks.size()) {
      ticks.resize(std::min<std::uint64_t>(8192, move.steps - first));
      table->read(first, ticks);
      benchmark::DoNotOptimize(ticks.data());
    }
    ticks.resize(8192);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(move.steps));
  state.SetLabel("pulses");
}
BENCHMARK_CAPTURE(pulse_table, ramps_only, StepperMove{1'000'000, 1e9, 2.0, 1.5, 84e6})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pulse_table, mostly_cruise, StepperMove{1'000'000, 1e5, 0.5, 0.4, 84e6})
    ->Unit(benchmark::kMillisecond);

}  // namespace
