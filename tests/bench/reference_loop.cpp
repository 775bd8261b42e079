/// A fixed piece of work whose cost stands beside every figure: absolute times drift from machine to machine and from
/// hour to hour, ratios to this loop much less.

#include <benchmark/benchmark.h>

#include <cmath>

namespace {

/// 1000 dependent square roots, divisions and additions: bound by latency, not by memory or by the compiler's skill.
void reference_loop(benchmark::State& state) {
  constexpr int kSteps = 1000;
  for (auto _ : state) {
    double x = 1.0;
    benchmark::DoNotOptimize(x);
    for (int i = 0; i < kSteps; ++i) x = std::sqrt(x + 1.0 / x);
    benchmark::DoNotOptimize(x);
  }
  state.SetItemsProcessed(state.iterations() * kSteps);
  state.SetLabel("steps");
}
BENCHMARK(reference_loop);

}  // namespace
