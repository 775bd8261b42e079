#include "plots/profile_series.h"

#include <algorithm>
#include <cmath>

#include "toolpace/path/path.h"

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
  for (std::size_t i = first; i < last; ++i) {
    if (outcome.commands) add_finite(extent.feed, (*outcome.commands)[i].feed);
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

AxisMotion axis_state(const Outcome& outcome, std::size_t block, double time, std::size_t axis) {
  if (const TimeSpline* spline = spline_at(outcome.plan, time)) return axis_motion(*spline, time, axis);
  const Path& path = *outcome.path;
  const PhaseState s = motion_at(outcome.plan, time);
  const double start = motion_at(outcome.plan, outcome.node_time[block]).distance;
  const double along = std::clamp(s.distance - start, 0.0, path.length[block]);
  const Frame frame = frame_at(path, block, along);
  const auto i = static_cast<Eigen::Index>(axis);
  return {frame.first[i] * s.speed, frame.first[i] * s.acceleration + frame.second[i] * s.speed * s.speed,
          frame.first[i] * s.jerk + 3 * frame.second[i] * s.speed * s.acceleration +
              frame.third[i] * s.speed * s.speed * s.speed};
}

MotionExtent axis_extent(const Outcome& outcome, std::size_t block, double begin, double end, std::size_t axis) {
  constexpr int kInstants = 8;
  const auto& plan = outcome.plan;
  MotionExtent extent;
  const bool line = outcome.path->kind[block] == SegmentKind::line;
  const double share = line ? start_direction(*outcome.path, block)[static_cast<Eigen::Index>(axis)] : 0.0;
  for (std::size_t i = phase_at(plan, begin); i < plan.phases.size() && plan.phases[i].begin <= end; ++i) {
    const double from = std::max(begin, plan.phases[i].begin);
    const double to = std::min(end, plan.phases[i].begin + plan.phases[i].duration);
    if (to < from || (to == from && end > begin)) continue;
    if (line && (plan.splines.empty() || !spline_at(plan, (from + to) / 2))) {
      extent.add(motion_bounds(plan, i, from, to).scaled(share));
      continue;
    }
    for (int k = 0; k < kInstants; ++k) {
      // A hair inside, so that a corner belongs to the block on its own side.
      const double at = std::clamp(static_cast<double>(k) / (kInstants - 1), 1e-6, 1 - 1e-6);
      const AxisMotion m = axis_state(outcome, block, from + (to - from) * at, axis);
      extent.add(PhaseBounds{{m.speed, m.speed}, {m.acceleration, m.acceleration}, {m.jerk, m.jerk}});
    }
  }
  return extent;
}

MotionExtent axis_extent_of_blocks(const Outcome& outcome, std::size_t first, std::size_t last, std::size_t axis) {
  MotionExtent extent;
  for (std::size_t i = first; i < last; ++i) {
    extent.add(axis_extent(outcome, i, outcome.node_time[i], outcome.node_time[i + 1], axis));
  }
  return extent;
}

const ProfileSeries::AxisPyramid& ProfileSeries::axis(std::size_t axis) const {
  std::call_once(axis_made_.at(axis), [&] {
    if (blocks.size() > 0) {
      axes_[axis] = AxisPyramid(blocks.size(), [&](std::size_t first, std::size_t last) {
        return axis_extent_of_blocks(*outcome, first, last, axis);
      });
    }
    axis_ready_[axis] = true;
  });
  return axes_[axis];
}

void make_axes(const ProfileSeries& series, const ShownAxes& shown) {
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (shown[i]) (void)series.axis(i);
  }
}

bool has_axes(const ProfileSeries& series, const ShownAxes& shown) {
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (shown[i] && !series.is_axis_made(i)) return false;
  }
  return true;
}

MotionExtent axis_whole(const ProfileSeries& series, std::size_t axis) {
  const auto& pyramid = series.axis(axis);
  return pyramid.query(0, pyramid.size(), [&](std::size_t first, std::size_t last) {
    return axis_extent_of_blocks(*series.outcome, first, last, axis);
  });
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
