#include "drawing/profile_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "toolpace/plan/plan.h"
#include "toolpace/sample/motion.h"

namespace toolpace::ui {
namespace {

constexpr double kPixelsPerPoint = 1.5;
constexpr double kLeastPoints = 6;  // of a bent phase, however short
constexpr double kOneLine = 0.01;   // sides of the speed that are nearer to each other, of its peak, are drawn as one
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

/// The window cut to the plan; its pixels keep their width.
TimeWindow clipped(const ProfileSeries& series, const TimeWindow& window) {
  const double begin = std::max(window.begin, 0.0), end = std::min(window.end, series.duration());
  const double share = (end - begin) / (window.end - window.begin);
  return {begin, end, std::max(static_cast<int>(std::lround(window.columns * share)), 1)};
}

/// Least and greatest value of one pixel as a vertical stroke that goes on where the last one stopped.
void add_stroke(Curve& curve, double time, const Extent& extent) {
  if (extent.is_empty()) return curve.add(time, kNothing);
  if (extent.low == extent.high) return curve.add(time, extent.low);
  const double last = curve.value.isEmpty() ? extent.low : curve.value.back();
  const bool upwards = !(std::abs(last - extent.high) < std::abs(last - extent.low));
  curve.add(time, upwards ? extent.low : extent.high);
  curve.add(time, upwards ? extent.high : extent.low);
}

void add_strokes(MotionCurves& curves, double time, const MotionExtent& extent) {
  for (std::size_t i = 0; i < kMotionTrackCount; ++i) add_stroke(curves[i], time, extent[i]);
}

void add_values(MotionCurves& curves, double time, const PhaseState& state) {
  for (std::size_t i = 0; i < kMotionTrackCount; ++i) curves[i].add(time, kMotionTracks[i].value(state));
}

/// A part of one phase.
void add_exact(MotionCurves& curves, Motion& motion, const Phase& p, const TimeWindow& part, double pixel) {
  const double from = part.begin, to = part.end;
  const bool bent = p.rate != 0 || motion.at((from + to) / 2).leaves_path();
  const int parts =
      bent ? static_cast<int>(std::clamp((to - from) / pixel / kPixelsPerPoint, kLeastPoints, 4000.0)) : 1;
  for (int k = 0; k <= parts; ++k) {
    const double time = k == parts ? to : from + (to - from) * k / parts;
    const PhaseState state =
        motion.leaves_path() ? motion.at(time).along() : evaluate(p, std::clamp(time - p.begin, 0.0, p.duration));
    add_values(curves, time, state);
  }
}

SplitExtent split_between(const ProfileSeries& series, double begin, double end) {
  const MotionPlan& plan = series.outcome->plan;
  const auto scan = [&](std::size_t first, std::size_t last) { return motion_extent(*series.outcome, first, last); };
  Motion motion(*series.outcome->path, plan);
  const std::size_t first = motion.at(begin).phase(), last = motion.at(end).phase();
  SplitExtent extent;
  const auto add = [&](double from, double to) {
    const PhaseBounds bounds = motion.bounds(from, to);
    extent.all.add(bounds);
    if (is_cutting(*series.outcome, (from + to) / 2)) extent.cutting.add(bounds);
  };
  if (last <= first + 1) {
    if (last == first) return add(begin, end), extent;
    add(begin, plan.phases[last].begin);
    add(plan.phases[last].begin, end);
    return extent;
  }
  add(begin, plan.phases[first + 1].begin);
  add(plan.phases[last].begin, end);
  extent.add(series.phases.query(first + 1, last, scan));
  return extent;
}

MotionExtent extent_between(const ProfileSeries& series, double begin, double end) {
  return split_between(series, begin, end).all;
}

std::size_t phase_at(const ProfileSeries& series, double time) {
  return Motion(*series.outcome->path, series.outcome->plan).at(time).phase();
}

/// One value of the blocks as steps in time.
struct StepCurve {
  Curve& curve;
  void add(double begin, double end, const Extent& extent, bool upper) {
    const double value = extent.is_empty() ? kNothing : upper ? extent.high : extent.low;
    const bool goes_on = !curve.value.isEmpty() && curve.value.back() == value;
    if (goes_on) {
      curve.time.back() = end;
      return;
    }
    curve.add(begin, value);
    curve.add(end, value);
  }
};

void add_caps(CapCurves& curves, double begin, double end, const CapExtent& extent) {
  StepCurve{curves.feed}.add(begin, end, extent.feed, true);
  for (std::size_t i = 0; i < kMotionTrackCount; ++i) {
    const bool has_high = !extent[i].is_empty() && extent[i].high > 0,
               has_low = !extent[i].is_empty() && extent[i].low < 0;
    StepCurve{curves.high[i]}.add(begin, end, has_high ? extent[i] : Extent{}, true);
    StepCurve{curves.low[i]}.add(begin, end, has_low ? extent[i] : Extent{}, false);
  }
}

}  // namespace

bool is_dense(const ProfileSeries& series, const TimeWindow& whole) {
  if (series.is_empty()) return false;
  const TimeWindow window = clipped(series, whole);
  if (!(window.end > window.begin)) return false;
  const std::size_t count = phase_at(series, window.end) - phase_at(series, window.begin);
  return count >= static_cast<std::size_t>(window.columns) / 2 + 2;
}

std::vector<Extent> speed_extents(const ProfileSeries& series, const TimeWindow& window) {
  std::vector<Extent> extents(static_cast<std::size_t>(std::max(window.columns, 0)));
  if (series.is_empty()) return extents;
  const double pixel = (window.end - window.begin) / window.columns, total = series.duration();
  for (std::size_t column = 0; column < extents.size(); ++column) {
    const double begin = window.begin + static_cast<double>(column) * pixel, end = begin + pixel;
    if (end < 0 || begin > total) continue;
    extents[column] = extent_between(series, std::max(begin, 0.0), std::min(end, total))[kSpeedTrack];
  }
  return extents;
}

MotionExtent cutting_extent(const ProfileSeries& series, const TimeWindow& whole) {
  if (series.is_empty()) return {};
  const TimeWindow window = clipped(series, whole);
  return window.end > window.begin ? split_between(series, window.begin, window.end).cutting : MotionExtent{};
}

MotionCurves motion_curves(const ProfileSeries& series, const TimeWindow& whole) {
  MotionCurves curves;
  if (series.is_empty()) return curves;
  const TimeWindow window = clipped(series, whole);
  if (!(window.end > window.begin)) return curves;
  const double pixel = (window.end - window.begin) / window.columns;
  if (is_dense(series, whole)) {
    for (int column = 0; column < window.columns; ++column) {
      const double begin = window.begin + column * pixel, middle = begin + pixel / 2;
      const MotionExtent extent = extent_between(series, begin, begin + pixel);
      add_strokes(curves, middle, extent);
    }
    return curves;
  }
  const auto& phases = series.outcome->plan.phases;
  Motion motion(*series.outcome->path, series.outcome->plan);
  const std::size_t first = motion.at(window.begin).phase(), last = motion.at(window.end).phase();
  double from = window.begin;
  for (std::size_t i = first; i <= last; ++i) {
    const double to = std::min(phases[i].begin + phases[i].duration, window.end);
    if (!(to > from)) continue;
    add_exact(curves, motion, phases[i], {from, to, 1}, pixel);
    from = to;
  }
  return curves;
}

MotionEnvelope motion_envelope(const ProfileSeries& series, const TimeWindow& whole) {
  MotionEnvelope sides;
  if (!is_dense(series, whole)) {
    sides.high = motion_curves(series, whole);
    return sides;
  }
  // Three pixels a point: dashes of two sides that jump every pixel cannot be told from noise.
  TimeWindow window = clipped(series, whole);
  window.columns = std::max(window.columns / 3, 1);
  const double pixel = (window.end - window.begin) / window.columns;
  std::vector<MotionExtent> extents;
  for (int column = 0; column < window.columns; ++column) {
    extents.push_back(extent_between(series, window.begin + column * pixel, window.begin + (column + 1) * pixel));
  }
  // The speed seldom changes within three pixels: two lines of dashes on each other are no dashes.
  const auto is_parted = [&](std::size_t column) {
    const Extent& speed = extents[column][kSpeedTrack];
    return speed.high - speed.low >= kOneLine * series.whole[kSpeedTrack].high;
  };
  for (std::size_t column = 0; column < extents.size(); ++column) {
    const double middle = window.begin + (static_cast<double>(column) + 0.5) * pixel;
    // The lower side begins and ends on the upper one.
    const bool has_low = is_parted(column) || (column > 0 && is_parted(column - 1)) ||
                         (column + 1 < extents.size() && is_parted(column + 1));
    for (std::size_t i = 0; i < kMotionTrackCount; ++i) {
      sides.high[i].add(middle, extents[column][i].high);
      sides.low[i].add(middle, i != kSpeedTrack || has_low ? extents[column][i].low : kNothing);
    }
  }
  return sides;
}

CapCurves cap_curves(const ProfileSeries& series, const TimeWindow& whole) {
  CapCurves curves;
  if (series.is_empty() || series.blocks.size() == 0) return curves;
  const Outcome& outcome = *series.outcome;
  const TimeWindow window = clipped(series, whole);
  if (!(window.end > window.begin)) return curves;
  const auto scan = [&](std::size_t first, std::size_t last) { return cap_extent(outcome, first, last); };
  const std::size_t first = segment_at(outcome.node_time, window.begin),
                    last = segment_at(outcome.node_time, window.end);
  if (last - first < static_cast<std::size_t>(window.columns)) {
    for (std::size_t i = first; i <= last; ++i) {
      const double begin = std::max(outcome.node_time[i], window.begin),
                   end = std::min(outcome.node_time[i + 1], window.end);
      if (end > begin) add_caps(curves, begin, end, scan(i, i + 1));
    }
    return curves;
  }
  const double pixel = (window.end - window.begin) / window.columns;
  for (int column = 0; column < window.columns; ++column) {
    const double begin = window.begin + column * pixel;
    const std::size_t from = segment_at(outcome.node_time, begin), to = segment_at(outcome.node_time, begin + pixel);
    add_caps(curves, begin, begin + pixel, series.blocks.query(from, to + 1, scan));
  }
  return curves;
}

namespace {

void add_axis_block(MotionCurves& curves, Motion& motion, std::size_t block, const TimeWindow& part, std::size_t axis) {
  const auto i = static_cast<Eigen::Index>(axis);
  const int parts = std::clamp(part.columns / 2, 2, 2000);
  for (int k = 0; k <= parts; ++k) {
    // A hair inside the block, so that a corner is a step and not a slope.
    const double share = std::clamp(static_cast<double>(k) / parts, 1e-6, 1 - 1e-6);
    const double time = part.begin + (part.end - part.begin) * share;
    const AxisMotion m = motion.at(time, block).axes();
    add_values(curves, time, {m.position[i], m.speed[i], m.acceleration[i], m.jerk[i]});
  }
}

/// Exact: blocks that lie wholly between the times come from the pyramid, the two at the ends are cut.
MotionExtent axis_extent_between(const ProfileSeries& series, double begin, double end, std::size_t axis) {
  const Outcome& outcome = *series.outcome;
  const std::size_t first = segment_at(outcome.node_time, begin), last = segment_at(outcome.node_time, end);
  Motion motion(*outcome.path, outcome.plan);
  const auto part = [&](std::size_t i) {
    const double from = std::max(begin, outcome.node_time[i]);
    MotionExtent extent;
    extent.add(motion.bounds(from, std::max(from, std::min(end, outcome.node_time[i + 1])), axis));
    return extent;
  };
  MotionExtent extent = part(first);
  if (last == first) return extent;
  extent.add(part(last));
  extent.add(series.axis(axis).query(first + 1, last, [&](std::size_t from, std::size_t to) {
    return axis_extent_of_blocks(outcome, from, to, axis);
  }));
  return extent;
}

}  // namespace

MotionCurves axis_curves(const ProfileSeries& series, const TimeWindow& whole, std::size_t axis) {
  MotionCurves curves;
  if (series.is_empty() || series.blocks.size() == 0) return curves;
  const Outcome& outcome = *series.outcome;
  const TimeWindow window = clipped(series, whole);
  if (!(window.end > window.begin)) return curves;
  const double pixel = (window.end - window.begin) / window.columns;
  const std::size_t first = segment_at(outcome.node_time, window.begin),
                    last = segment_at(outcome.node_time, window.end);
  if (last - first < static_cast<std::size_t>(window.columns) / 2 + 2) {
    Motion motion(*outcome.path, outcome.plan);
    for (std::size_t i = first; i <= last; ++i) {
      const double begin = std::max(outcome.node_time[i], window.begin),
                   end = std::min(outcome.node_time[i + 1], window.end);
      if (end > begin) add_axis_block(curves, motion, i, {begin, end, static_cast<int>((end - begin) / pixel)}, axis);
    }
    return curves;
  }
  for (int column = 0; column < window.columns; ++column) {
    const double begin = window.begin + column * pixel;
    const MotionExtent extent = axis_extent_between(series, begin, begin + pixel, axis);
    add_strokes(curves, begin + pixel / 2, extent);
  }
  return curves;
}

}  // namespace toolpace::ui
