#include "plots/profile_series.h"

#include <algorithm>
#include <cmath>

namespace toolpace::ui {
namespace {

void add_finite(Extent& extent, double value) {
  if (std::isfinite(value)) extent.add(static_cast<float>(value));
}

}  // namespace

MotionExtent motion_extent(const Outcome& outcome, std::size_t first, std::size_t last) {
  MotionExtent extent;
  for (std::size_t i = first; i < last; ++i) extent.add(motion_bounds(outcome.plan, i));
  return extent;
}

CapExtent cap_extent(const Outcome& outcome, std::size_t first, std::size_t last) {
  CapExtent extent;
  const Moves* moves = outcome.job && outcome.job->program ? &outcome.job->program->moves : nullptr;
  const double override_factor = outcome.job ? outcome.job->options.feed_override : 1.0;
  for (std::size_t i = first; i < last; ++i) {
    const std::uint32_t row = outcome.path->move[i];
    if (moves && row < moves->size() && moves->kind[row] != MoveKind::rapid && moves->feed[row] > 0) {
      add_finite(extent.feed, moves->feed[row] * override_factor);
    }
    if (i >= outcome.limits.size()) continue;
    add_finite(extent.speed, outcome.limits.block_cap[i]);
    const Dynamics& dynamics = outcome.limits.dynamics_of(i);
    add_finite(extent.acceleration, dynamics.up.acceleration);
    add_finite(extent.acceleration, -dynamics.down.acceleration);
    const double jerk = std::max(dynamics.up.jerk, dynamics.down.jerk);
    add_finite(extent.jerk, jerk);
    add_finite(extent.jerk, -jerk);
  }
  return extent;
}

std::shared_ptr<const ProfileSeries> make_profile_series(std::shared_ptr<const Outcome> outcome) {
  auto series = std::make_shared<ProfileSeries>();
  series->outcome = outcome;
  if (!outcome) return series;
  const auto scan = [&](std::size_t first, std::size_t last) { return motion_extent(*outcome, first, last); };
  const std::size_t count = outcome->plan.phases.size();
  series->phases = decltype(series->phases)(count, scan);
  series->whole = series->phases.query(0, count, scan);
  if (outcome->path && outcome->path->size() > 0 && outcome->node_time.size() == outcome->path->size() + 1) {
    series->blocks = decltype(series->blocks)(
        outcome->path->size(), [&](std::size_t first, std::size_t last) { return cap_extent(*outcome, first, last); });
  }
  series->causes = CauseTimes(outcome->restraints);
  return series;
}

}  // namespace toolpace::ui
