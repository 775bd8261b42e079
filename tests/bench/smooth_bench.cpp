/// What rounding corners and planning through the tolerance tube cost.

#include <benchmark/benchmark.h>

#include "smooth_moves.h"
#include "toolpace/limits/limit_speed.h"
#include "toolpace/path/blend_path.h"
#include "toolpace/path/build_path.h"
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

void blend_and_plan_blocks(benchmark::State& state) {
  const Moves moves = bench::smooth_moves(static_cast<std::size_t>(state.range(0)));
  const Path path = *build_path(moves, 0.0);
  PlanOptions options;
  options.law = LawKind::seven_phase;
  options.ramps = Ramps::span;
  options.corner.rule = CornerRule::blend;
  LimitOptions limit_options;
  limit_options.corner = options.corner;
  const Machine machine = test_machine();
  for (auto _ : state) {
    const auto blended = blend_path(path, moves, {});
    const auto limits = limit_speed(blended->path, moves, machine, limit_options);
    benchmark::DoNotOptimize(plan_motion(*limits, options));
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
  state.SetLabel("blocks");
}
BENCHMARK(blend_and_plan_blocks)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

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
  const auto limits = limit_speed(blended->path, moves, machine, limit_options);
  const auto plan = plan_motion(*limits, options);
  const auto speed = commanded_speeds(blended->path, moves, machine, limit_options);
  for (auto _ : state) benchmark::DoNotOptimize(retime(blended->path, machine, *limits, speed, *plan));
  state.SetItemsProcessed(state.iterations() * state.range(0));
  state.SetLabel("blocks");
}
BENCHMARK(retime_blocks)->Arg(5'000)->Unit(benchmark::kMillisecond);

/// Items are milliseconds of motion: the budget is 50 µs for each, on one core.
void smooth_milliseconds(benchmark::State& state) {
  const Moves moves = bench::smooth_moves(static_cast<std::size_t>(state.range(0)));
  const Path path = *build_path(moves, 0.0);
  const Machine machine = test_machine();
  const TubePath tube = build_tube(path, moves, machine, {}, 0, path.size());
  double duration = 0;
  for (auto _ : state) duration = plan_tube(tube, tube_limits(machine), 0.001)->duration;
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(duration * 1e3));
  state.SetLabel("ms of motion");
}
BENCHMARK(smooth_milliseconds)->Arg(5'000)->Arg(50'000)->Unit(benchmark::kMillisecond);

}  // namespace
