#include "toolpace/tune/sweep.h"

#include <algorithm>
#include <memory>

#include "toolpace/pipeline/many.h"

namespace toolpace {
namespace {

constexpr double kKnee = 1.005;  // of the time at full depth

std::vector<std::optional<std::size_t>> depths_up_to(std::size_t blocks) {
  std::vector<std::optional<std::size_t>> depths;
  for (std::size_t octave = 1; octave < blocks; octave *= 2) {
    depths.emplace_back(octave);
    if (octave >= 2 && octave + octave / 2 < blocks) depths.emplace_back(octave + octave / 2);
  }
  depths.emplace_back(std::nullopt);
  return depths;
}

}  // namespace

Result<LookaheadSweep> sweep_lookahead(const Job& job, const Monitor& monitor) {
  const auto depths = depths_up_to(job.program->moves.size());
  const auto plan_at = [&](std::size_t i, const Monitor& quiet) -> Result<SweepPoint> {
    auto at_depth = std::make_shared<Job>(job);
    at_depth->options.lookahead = depths[i];
    at_depth->refined = false;  // only a whole program is timed anew
    auto outcome = run(at_depth, quiet);
    if (!outcome) return tl::unexpected(outcome.error());
    return SweepPoint{depths[i], outcome->summary.cycle_time};
  };
  auto points = for_many<SweepPoint>(depths.size(), kPlansAtOnce, monitor, plan_at);
  if (!points) return tl::unexpected(points.error());
  const double best = points->back().cycle_time;
  const auto is_close = [&](const SweepPoint& p) { return p.cycle_time <= best * kKnee; };
  const auto knee = std::find_if(points->begin(), points->end(), is_close);
  const auto index = static_cast<std::size_t>(knee - points->begin());
  return LookaheadSweep{std::move(*points), index};
}

}  // namespace toolpace
