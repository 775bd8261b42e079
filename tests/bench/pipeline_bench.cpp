/// What a whole program costs: geometry, speed limits, planning and sampling, each stage and all of them as one job.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "smooth_moves.h"
#include "toolpace/limits/limit_speed.h"
#include "toolpace/machine/setup.h"
#include "toolpace/path/build_path.h"
#include "toolpace/pipeline/job.h"
#include "toolpace/sample/sampler.h"

namespace {

using namespace toolpace;

constexpr std::size_t kBlocks = 1'000'000;

std::shared_ptr<Job> make_job(std::optional<std::size_t> lookahead, Ramps ramps) {
  static const auto reading = [] {
    auto made = std::make_shared<Reading>();
    made->moves = bench::smooth_moves(kBlocks);
    return std::shared_ptr<const Reading>(std::move(made));
  }();
  auto job = std::make_shared<Job>();
  const Setup setup = default_setup();
  job->program_name = "smooth";
  job->program = reading;
  job->machine = setup.machine;
  job->options = setup.options;
  job->options.lookahead = lookahead;
  job->options.ramps = ramps;
  return job;
}

void count_blocks(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kBlocks));
  state.SetLabel("blocks");
}

void geometry(benchmark::State& state) {
  const auto job = make_job({}, Ramps::block);
  for (auto _ : state) benchmark::DoNotOptimize(build_path(job->program->moves, 0.0));
  count_blocks(state);
}
BENCHMARK(geometry)->Unit(benchmark::kMillisecond);

void speed_limits(benchmark::State& state) {
  const auto job = make_job({}, Ramps::block);
  const auto path = build_path(job->program->moves, 0.0);
  if (!path) return state.SkipWithError(path.error().message.c_str());
  const Commands commands = command_path(*path, job->program->moves, command_options(job->machine));
  for (auto _ : state) benchmark::DoNotOptimize(limit_speed(*path, commands, job->machine, {}));
  count_blocks(state);
}
BENCHMARK(speed_limits)->Unit(benchmark::kMillisecond);

void whole_job(benchmark::State& state, std::optional<std::size_t> lookahead, Ramps ramps) {
  const auto job = make_job(lookahead, ramps);
  for (auto _ : state) {
    const auto outcome = run(job);
    if (!outcome) return state.SkipWithError(outcome.error().message.c_str());
  }
  count_blocks(state);
}
BENCHMARK_CAPTURE(whole_job, quintic_n8, std::size_t{8}, Ramps::block)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole_job, quintic_all, std::nullopt, Ramps::block)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole_job, quintic_span, std::nullopt, Ramps::span)->Unit(benchmark::kMillisecond);

/// A NURBS of degree 3 with weights, of a few millimetres a span: as sculptured parts are sent by some CAM systems.
std::shared_ptr<Job> spline_job() {
  constexpr int kPoints = 400;
  auto reading = std::make_shared<Reading>();
  Moves& moves = reading->moves;
  SplineDetail spline;
  spline.degree = 3;
  for (int k = 0; k < kPoints; ++k) {
    spline.points.emplace_back(3.0 * k, 4 * std::sin(0.7 * k) + 2 * std::cos(1.9 * k), 0.0);
    spline.weights.push_back(1 + 0.4 * std::sin(1.3 * k));
  }
  for (int k = 0; k <= kPoints + 3; ++k) spline.knots.push_back(std::clamp(k - 3, 0, kPoints - 3));
  moves.start.head<3>() = spline.points.front();
  moves.kind = {MoveKind::spline};
  moves.line = {1};
  moves.file = {0};
  moves.mode = {0};
  moves.detail = {0};
  moves.end = {AxisVector::Zero()};
  moves.end[0].head<3>() = spline.points.back();
  moves.feed = {50};
  moves.splines = {spline};
  auto job = std::make_shared<Job>(*make_job({}, Ramps::block));
  job->program = reading;
  return job;
}

void sample_job(benchmark::State& state, const std::shared_ptr<Job>& job) {
  const auto outcome = run(job);
  if (!outcome) return state.SkipWithError(outcome.error().message.c_str());
  std::size_t rows = 0;
  for (auto _ : state) {
    Sampler sampler(*outcome->path, outcome->plan, job->program->moves, job->machine.period);
    rows += sampler.rows();
    for (Setpoints chunk; sampler.next(chunk);) benchmark::DoNotOptimize(chunk.speed.data());
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(rows));
  state.SetLabel("setpoints");
}

void sampling(benchmark::State& state) { sample_job(state, make_job({}, Ramps::block)); }
BENCHMARK(sampling)->Unit(benchmark::kMillisecond);

void sampling_a_spline(benchmark::State& state) { sample_job(state, spline_job()); }
BENCHMARK(sampling_a_spline)->Unit(benchmark::kMillisecond);

}  // namespace
