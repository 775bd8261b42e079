/// Polylines all the way to a plan: what can be read is planned without a crash, finite, and ends at rest.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <utility>

#include "toolpace/machine/setup.h"
#include "toolpace/nc/reader.h"
#include "toolpace/pipeline/job.h"

namespace {

using namespace toolpace;

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
  const std::string_view text(reinterpret_cast<const char*>(data + 1), size - 1);
  auto reading = read_text(text, "fuzz.csv");
  if (!reading || reading->refused || reading->moves.size() > 500) return 0;
  auto job = std::make_shared<Job>();
  job->program = std::make_shared<const Reading>(std::move(*reading));
  job->machine = default_setup().machine;
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
