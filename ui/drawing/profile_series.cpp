#include "drawing/profile_series.h"

#include <algorithm>
#include <cmath>

#include "toolpace/sample/motion.h"

namespace toolpace::ui {
namespace {

void add_finite(Extent& extent, double value) {
  if (std::isfinite(value)) extent.add(static_cast<float>(value));
}

}  // namespace

bool is_cutting(const Outcome& outcome, double time) {
  const auto& times = outcome.node_time;
  if (!outcome.commands || times.size() < 2) return true;
  const auto behind = std::upper_bound(times.begin(), times.end(), time);
  const auto block = std::clamp<std::ptrdiff_t>(behind - times.begin() - 1, 0, std::ssize(times) - 2);
  return !(*outcome.commands)[static_cast<std::size_t>(block)].is_rapid;
}

SplitExtent motion_extent(const Outcome& outcome, std::size_t first, std::size_t last) {
  SplitExtent extent;
  Motion motion(*outcome.path, outcome.plan);
  for (std::size_t i = first; i < last; ++i) {
    const Phase& p = outcome.plan.phases[i];
    const PhaseBounds bounds = motion.bounds(p.begin, p.begin + p.duration);
    extent.all.add(bounds);
    if (is_cutting(outcome, p.begin + p.duration / 2)) extent.cutting.add(bounds);
  }
  return extent;
}

CapExtent cap_extent(const Outcome& outcome, std::size_t first, std::size_t last) {
  CapExtent extent;
  for (std::size_t i = first; i < last; ++i) {
    if (outcome.commands) add_finite(extent.feed, (*outcome.commands)[i].feed);
    if (i >= outcome.limits.size()) continue;
    for (std::size_t k = 0; k < kMotionTrackCount; ++k) {
      const Interval cap = kMotionTracks[k].cap(outcome.limits, i);
      add_finite(extent[k], cap.low);
      add_finite(extent[k], cap.high);
    }
  }
  return extent;
}

MotionExtent axis_extent_of_blocks(const Outcome& outcome, std::size_t first, std::size_t last, std::size_t axis) {
  MotionExtent extent;
  Motion motion(*outcome.path, outcome.plan);
  for (std::size_t i = first; i < last; ++i) {
    extent.add(motion.bounds(outcome.node_time[i], outcome.node_time[i + 1], axis));
  }
  return extent;
}

PhaseState ProfileSeries::state_at(double time) const { return Motion(*outcome->path, outcome->plan).at(time).along(); }

bool ProfileSeries::is_jerk_unbounded() const {
  const auto is_nothing = [](const Extent& e) { return e.low == 0 && e.high == 0; };
  return !is_empty() && is_nothing(whole[kJerkTrack]) && !is_nothing(whole[kAccelerationTrack]);
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
  series->whole = series->phases.query(0, count, scan).all;
  if (outcome->path && outcome->path->size() > 0 && outcome->node_time.size() == outcome->path->size() + 1) {
    series->blocks = decltype(series->blocks)(
        outcome->path->size(), [&](std::size_t first, std::size_t last) { return cap_extent(*outcome, first, last); });
  }
  series->causes = CauseTimes(outcome->restraints);
  return series;
}

}  // namespace toolpace::ui
