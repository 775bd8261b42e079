/// Planning a million blocks: paths of 5000 blocks, two hundred times over.

#include <benchmark/benchmark.h>

#include <map>
#include <string>

#include "plan_cases.h"
#include "toolpace/bound/path_bound.h"
#include "toolpace/plan/plan.h"
#include "toolpace/plan/restraint.h"

namespace toolpace {
namespace {

constexpr std::size_t kCopies = 200;

/// Path limits of 2000 mm/s² and 50 000 mm/s³, servo rule at 1 ms; loaded once.
const SpeedLimits& load(const std::string& name, std::size_t copies = kCopies) {
  static std::map<std::string, std::optional<SpeedLimits>> loaded;
  auto& limits = loaded[name + std::to_string(copies)];
  if (!limits) {
    test::PolylineRules rules{test::symmetric(2000, 5e4)};
    rules.servo_acceleration = 2000;
    limits = test::limits_of(test::polyline(name), rules, copies);
  }
  return *limits;
}

void plan(benchmark::State& state, const char* name, const PlanOptions& options, std::size_t copies = kCopies) {
  const SpeedLimits& limits = load(name, copies);
  for (auto _ : state) {
    auto result = plan_motion(limits, options);
    benchmark::DoNotOptimize(result);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(limits.size()));
  state.SetLabel("blocks");
}

PlanOptions block(LawKind law, std::optional<std::size_t> blocks = {}) {
  PlanOptions options;
  options.law = law;
  options.lookahead = blocks;
  return options;
}

PlanOptions span(LawKind law, std::optional<std::size_t> blocks = {}) {
  PlanOptions options = block(law, blocks);
  options.ramps = Ramps::span;
  return options;
}

void explain_plan(benchmark::State& state) {
  const SpeedLimits& limits = load("smooth");
  const PlanOptions options = span(LawKind::seven_phase);
  const auto made = plan_motion(limits, options);
  const auto times = node_times(limits, *made);
  for (auto _ : state) {
    auto restraints = explain(limits, *made, times, options);
    benchmark::DoNotOptimize(restraints);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(limits.size()));
  state.SetLabel("blocks");
}

void bound_plan(benchmark::State& state) {
  const SpeedLimits& limits = load("smooth");
  for (auto _ : state) benchmark::DoNotOptimize(path_bound(limits, LawKind::seven_phase));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(limits.size()));
  state.SetLabel("blocks");
}

/// Names hold signs that a macro's argument may not.
void add(const char* label, const char* path, const PlanOptions& options, std::size_t copies = kCopies) {
  benchmark::RegisterBenchmark((std::string("plan/") + label).c_str(), [=](benchmark::State& state) {
    plan(state, path, options, copies);
  })->Unit(benchmark::kMillisecond);
}

const bool registered = [] {
  add("block/quintic/all/smooth", "smooth", block(LawKind::quintic));
  add("block/quintic/all/random", "random", block(LawKind::quintic));
  add("block/quintic/N8/smooth", "smooth", block(LawKind::quintic, 8));
  add("block/quintic/all/smooth, a tenth of the blocks", "smooth", block(LawKind::quintic), kCopies / 10);
  add("block/seven-phase/all/smooth", "smooth", block(LawKind::seven_phase));
  add("span/seven-phase/all/random", "random", span(LawKind::seven_phase));
  add("span/seven-phase/all/smooth", "smooth", span(LawKind::seven_phase));
  add("span/seven-phase/all/line", "line", span(LawKind::seven_phase));
  add("span/seven-phase/all/circle", "circle", span(LawKind::seven_phase));
  add("span/seven-phase/N10000/smooth", "smooth", span(LawKind::seven_phase, 10000));
  add("span/seven-phase/all/smooth, a tenth of the blocks", "smooth", span(LawKind::seven_phase), kCopies / 10);
  add("span/trapezoid/all/random", "random", span(LawKind::trapezoid));
  add("span/trapezoid/all/smooth", "smooth", span(LawKind::trapezoid));
  add("span/quintic/all/smooth, a tenth of the blocks", "smooth", span(LawKind::quintic), kCopies / 10);
  return true;
}();

BENCHMARK(explain_plan)->Name("explain/smooth")->Unit(benchmark::kMillisecond);
BENCHMARK(bound_plan)->Name("bound/smooth")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace toolpace
