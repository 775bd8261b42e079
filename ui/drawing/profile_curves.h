#pragma once
/// The visible part of the motion plots as curves of a few points a pixel: exact phases where they can be told apart,
/// least and greatest value a pixel where not.

#include <QVector>
#include <vector>

#include "drawing/profile_series.h"

namespace toolpace::ui {

/// Points of a polyline, times ascending. A NaN value interrupts it.
struct Curve {
  QVector<double> time;   ///< [s]
  QVector<double> value;  ///< core units

  void add(double t, double v) {
    time.append(t);
    value.append(v);
  }
};

/// A stretch of time as wide as so many pixels.
struct TimeWindow {
  double begin, end;  ///< [s], begin < end
  int columns;        ///< ≥ 1
};

using MotionCurves = OfTracks<Curve>;

MotionCurves motion_curves(const ProfileSeries& series, const TimeWindow& window);

/// Least and greatest speed of each column of the window, for a miniature; empty outside the plan.
std::vector<Extent> speed_extents(const ProfileSeries& series, const TimeWindow& window);

/// Of what cuts in the window; empty where nothing does.
MotionExtent cutting_extent(const ProfileSeries& series, const TimeWindow& window);

/// True where the window holds too many phases to draw each: motion_curves() then strokes the range of each pixel.
bool is_dense(const ProfileSeries& series, const TimeWindow& window);

/// The two sides of those strokes as curves of their own, for a plan that is shown behind another. Where they hardly differ, that
/// of the speed is in `high` alone.
struct MotionEnvelope {
  MotionCurves high, low;
};
MotionEnvelope motion_envelope(const ProfileSeries& series, const TimeWindow& window);

struct CapCurves {
  Curve feed;
  MotionCurves high, low;  ///< of values that turn round a cap on either side
};

CapCurves cap_curves(const ProfileSeries& series, const TimeWindow& window);

/// Speed, acceleration and jerk of one axis [mm, rad based]. Where blocks share pixels, the range of each pixel is
/// stroked: no peak is lost, however many blocks there are.
MotionCurves axis_curves(const ProfileSeries& series, const TimeWindow& window, std::size_t axis);

}  // namespace toolpace::ui
