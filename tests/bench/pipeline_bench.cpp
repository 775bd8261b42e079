/// What a whole program costs: geometry, speed limits, planning and sampling, each stage and all of them as one job.

#include <benchmark/benchmark.h>

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

void sampling(benchmark::State& state) {
  const auto job = make_job({}, Ramps::block);
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
BENCHMARK(sampling)->Unit(benchmark::kMillisecond);

}  // namespace
