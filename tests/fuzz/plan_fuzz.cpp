/// Polylines all the way to a plan: what can be read is planned without a crash, finite, and ends at rest.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "polyline_job.h"

namespace {

using namespace toolpace;

constexpr std::size_t kMostMoves = 500;

/// The first byte chooses law, ramps and depth; the rest is the polyline.
PlanOptions options_of(std::uint8_t choice) {
  PlanOptions options = default_setup().options;
  options.law = static_cast<LawKind>(choice % 6);
  options.ramps = (choice / 6) % 2 == 0 ? Ramps::block : Ramps::span;
  if (choice / 12 % 2 == 1) options.lookahead = 1 + choice / 24;
  return options;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto job = fuzz::polyline_job(data + 1, size - 1, kMostMoves);
  if (!job) return 0;
  job->options = options_of(data[0]);
  const auto outcome = run(job);
  if (!outcome) return 0;
  if (!std::isfinite(outcome->summary.cycle_time) || outcome->summary.cycle_time < 0) std::abort();
  for (const auto& phase : outcome->plan.phases) {
    const auto end = evaluate(phase, phase.duration);
    if (!(phase.duration >= 0) || !std::isfinite(end.distance) || !std::isfinite(end.speed)) std::abort();
  }
  return 0;
}
