/// Polylines all the way to a proof, with every rule for corners: what is planned is judged, and told in numbers. The first byte
/// chooses the rule and its tolerance.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "polyline_job.h"
#include "toolpace/pipeline/prove.h"
#include "toolpace/pipeline/strategy.h"

namespace {

using namespace toolpace;

constexpr std::size_t kMostMoves = 12, kMostSetpoints = 10'000;

PlanOptions options_of(std::uint8_t choice) {
  constexpr std::array kRules = {CornerRule::stop, CornerRule::servo, CornerRule::junction, CornerRule::blend,
                                 CornerRule::smooth};
  PlanOptions options = default_setup().options;
  options.law = LawKind::seven_phase;
  options.ramps = choice % 2 == 0 ? Ramps::block : Ramps::span;
  options.corner.rule = kRules[choice / 2 % kRules.size()];
  options.corner.tolerance = std::pow(10.0, -choice / 10 % 6);
  return options;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto job = fuzz::polyline_job(data + 1, size - 1, kMostMoves);
  if (!job) return 0;
  for (auto& axis : job->machine.axes) axis.speed = 200, axis.acceleration = 4000, axis.jerk = 1e6;
  job->options = options_of(data[0]);
  // Motion through the tube is costly by the second, and a hundredfold under the sanitizers.
  const auto is_long = [](const Outcome& o) {
    return o.plan.cycle_time() > static_cast<double>(kMostSetpoints) * o.job->machine.period;
  };
  if (const auto quick = run(quick_version(*job)); !quick || is_long(*quick)) return 0;
  const auto outcome = run(job);
  if (!outcome || is_long(*outcome)) return 0;
  const auto report = prove(*outcome);
  if (!report) std::abort();
  for (const Check& check : report->checks) {
    if (std::isnan(check.value) || std::isnan(check.bound)) std::abort();
  }
  return 0;
}
