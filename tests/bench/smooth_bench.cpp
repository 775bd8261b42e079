/// What rounding corners and planning through the tolerance tube cost.

#include <benchmark/benchmark.h>

#include <stop_token>
#include <string>

#include "meter.h"
#include "places.h"
#include "smooth_moves.h"
#include "toolpace/limits/limit_speed.h"
#include "toolpace/nc/reader.h"
#include "toolpace/path/blend_path.h"
#include "toolpace/path/build_path.h"
#include "toolpace/pipeline/job.h"
#include "toolpace/plan/plan.h"
#include "toolpace/plan/retime/retime.h"
#include "toolpace/plan/smooth/build_tube.h"
#include "toolpace/plan/smooth/plan_tube.h"

namespace {

using namespace toolpace;

Machine test_machine() {
  Machine machine;
  for (std::size_t a = 0; a < 3; ++a) {
    machine.axes[a].speed = 100;
    machine.axes[a].acceleration = 2000;
    machine.axes[a].jerk = 50000;
  }
  return machine;
}

void blend_blocks(benchmark::State& state) {
  const Moves moves = bench::smooth_moves(static_cast<std::size_t>(state.range(0)));
  const Path path = *build_path(moves, 0.0);
  for (auto _ : state) benchmark::DoNotOptimize(blend_path(path, moves, {}));
  state.SetItemsProcessed(state.iterations() * state.range(0));
  state.SetLabel("blocks");
}
BENCHMARK(blend_blocks)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

/// Corners, limits and plan, as for `--corner blend`.
void blend_and_plan(benchmark::State& state, const Moves& moves) {
  const Path path = *build_path(moves, 0.0);
  PlanOptions options;
  options.law = LawKind::seven_phase;
  options.ramps = Ramps::span;
  options.corner.rule = CornerRule::blend;
  LimitOptions limit_options;
  limit_options.corner = options.corner;
  const Machine machine = test_machine();
  const auto work = [&] {
    const auto blended = blend_path(path, moves, {});
    const auto limits = limit_speed(blended->path, command_path(blended->path, moves, command_options(machine)),
                                    machine, limit_options);
    benchmark::DoNotOptimize(plan_motion(*limits, options));
  };
  for (auto _ : state) work();
  const auto blocks = static_cast<std::int64_t>(moves.size());
  state.counters["bytes_an_item"] = bench::peak_bytes(work) / static_cast<double>(blocks);
  state.SetItemsProcessed(state.iterations() * blocks);
  state.SetLabel("blocks");
}

void blend_and_plan_blocks(benchmark::State& state) {
  blend_and_plan(state, bench::smooth_moves(static_cast<std::size_t>(state.range(0))));
}
BENCHMARK(blend_and_plan_blocks)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

/// Copies of a path of tests/data, one behind the other.
void blend_and_plan_copies(benchmark::State& state, const std::string& name) {
  const auto reading = read_file(test::source_dir() / "tests/data" / (name + ".csv"));
  if (!reading) return state.SkipWithError(reading.error().message.c_str());
  Moves moves = reading->moves;
  const std::size_t blocks = moves.size();
  const AxisVector step = moves.end.back() - moves.start;
  const auto repeat = [&](auto& column) {
    column.reserve(blocks * static_cast<std::size_t>(state.range(0)));
    for (std::int64_t k = 1; k < state.range(0); ++k) {
      for (std::size_t i = 0; i < blocks; ++i) column.push_back(column[i]);
    }
  };
  repeat(moves.kind), repeat(moves.line), repeat(moves.file), repeat(moves.mode), repeat(moves.detail);
  repeat(moves.end), repeat(moves.feed);
  for (std::size_t i = blocks; i < moves.size(); ++i) moves.end[i] += static_cast<double>(i / blocks) * step;
  blend_and_plan(state, moves);
}
BENCHMARK_CAPTURE(blend_and_plan_copies, smooth, "smooth")->Arg(20)->Arg(200)->Unit(benchmark::kMillisecond);

/// The same path, timed anew under the axes' limits.
void retime_blocks(benchmark::State& state) {
  const Moves moves = bench::smooth_moves(static_cast<std::size_t>(state.range(0)));
  PlanOptions options;
  options.law = LawKind::seven_phase;
  options.ramps = Ramps::span;
  LimitOptions limit_options;
  limit_options.corner.rule = CornerRule::blend;
  const Machine machine = test_machine();
  const auto blended = blend_path(*build_path(moves, 0.0), moves, {});
  const Commands commands = command_path(blended->path, moves, command_options(machine));
  const auto limits = limit_speed(blended->path, commands, machine, limit_options);
  const auto plan = plan_motion(*limits, options);
  const RetimeTask task{blended->path, commands, machine, *limits, options};
  for (auto _ : state) benchmark::DoNotOptimize(retime(task, *plan, *plan));
  state.SetItemsProcessed(state.iterations() * state.range(0));
  state.SetLabel("blocks");
}
BENCHMARK(retime_blocks)->Arg(5'000)->Unit(benchmark::kMillisecond);

/// What `--corner smooth` still does after it was asked to stop, at 30 % of the way; all threads. The window wants 0.2 s.
void smooth_stop(benchmark::State& state) {
  auto job = std::make_shared<Job>();
  auto reading = std::make_shared<Reading>();
  reading->moves = bench::smooth_moves(5'000);
  job->program = reading;
  job->machine = test_machine();
  job->options.law = LawKind::seven_phase;
  job->options.ramps = Ramps::span;
  job->options.corner.rule = CornerRule::smooth;
  for (auto _ : state) {
    std::stop_source source;
    bench::Meter since;
    const Monitor monitor{source.get_token(), [&](double fraction) {
                            if (fraction < 0.3 || source.stop_requested()) return;
                            since = bench::Meter();
                            source.request_stop();
                          }};
    benchmark::DoNotOptimize(run(job, monitor));
    state.SetIterationTime(since.process());
  }
  state.SetItemsProcessed(state.iterations());
  state.SetLabel("stops");
}
BENCHMARK(smooth_stop)->UseManualTime()->Iterations(10)->Unit(benchmark::kMillisecond);

/// Items are milliseconds of motion: the budget is 50 µs for each, on one core.
void smooth_milliseconds(benchmark::State& state) {
  const Moves moves = bench::smooth_moves(static_cast<std::size_t>(state.range(0)));
  const Path path = *build_path(moves, 0.0);
  const Machine machine = test_machine();
  const TubePath tube = build_tube(path, command_path(path, moves, command_options(machine)), 0, path.size());
  double duration = 0;
  for (auto _ : state) duration = plan_tube(tube, tube_limits(machine), 0.001)->duration;
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(duration * 1e3));
  state.SetLabel("ms of motion");
}
BENCHMARK(smooth_milliseconds)->Arg(5'000)->Arg(50'000)->Unit(benchmark::kMillisecond);

}  // namespace
