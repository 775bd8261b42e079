#pragma once
/// What the motion plots draw, ready made on the worker thread: summaries over the phases of a plan. The curves
/// themselves are evaluated from the exact phases when they are drawn, for the visible time alone.

#include <array>
#include <atomic>
#include <memory>
#include <mutex>

#include "drawing/cause_times.h"
#include "drawing/motion_tracks.h"
#include "drawing/pyramid.h"
#include "toolpace/pipeline/job.h"

namespace toolpace::ui {

/// One value a track.
template <class Value>
struct OfTracks {
  std::array<Value, kMotionTrackCount> track;

  Value& operator[](std::size_t i) { return track[i]; }
  const Value& operator[](std::size_t i) const { return track[i]; }
};

/// Of a run of phases, along the path or of one axis [mm, rad, s].
struct MotionExtent : OfTracks<Extent> {
  void add(const MotionExtent& other) {
    for (std::size_t i = 0; i < kMotionTrackCount; ++i) track[i].add(other[i]);
  }
  void add(const PhaseBounds& bounds) {
    for (std::size_t i = 0; i < kMotionTrackCount; ++i) {
      const Interval range = kMotionTracks[i].range(bounds);
      track[i].add({static_cast<float>(range.low), static_cast<float>(range.high)});
    }
  }
};

/// The same, and what of it is cutting: rapids, which may be many times quicker, left out.
struct SplitExtent {
  MotionExtent all, cutting;

  void add(const SplitExtent& other) {
    all.add(other.all);
    cutting.add(other.cutting);
  }
};

/// What a run of blocks allows [mm, s]; what is unlimited stays empty.
struct CapExtent : OfTracks<Extent> {
  Extent feed;  ///< programmed, with the override; rapids left out

  void add(const CapExtent& other) {
    feed.add(other.feed);
    for (std::size_t i = 0; i < kMotionTrackCount; ++i) track[i].add(other[i]);
  }
};

using ShownAxes = std::array<bool, kAxisCount>;  // X … C

struct ProfileSeries {
  std::shared_ptr<const Outcome> outcome;
  Pyramid<SplitExtent, 8> phases;  // a phase's extremes cost a hundred times what reading a number does
  Pyramid<CapExtent, 16> blocks;   ///< empty where node_time is missing
  MotionExtent whole;
  CauseTimes causes;

  static constexpr std::size_t kAxes = kAxisCount;
  using AxisPyramid = Pyramid<MotionExtent, 8>;  // a block each
  /// What an axis does in each block; made when it is first asked for, from any thread. Empty without node_time.
  const AxisPyramid& axis(std::size_t axis) const;
  bool is_axis_made(std::size_t axis) const { return axis_ready_.at(axis); }

  double duration() const { return outcome ? outcome->plan.cycle_time() : 0.0; }
  /// Along the way that is run. @pre not empty
  PhaseState state_at(double time) const;
  /// Acceleration changes in steps, so that jerk has no values: 0 would be wrong.
  bool is_jerk_unbounded() const;
  bool is_empty() const { return !outcome || outcome->plan.phases.empty() || duration() <= 0; }

 private:
  mutable std::array<std::once_flag, kAxes> axis_made_;
  mutable std::array<std::atomic<bool>, kAxes> axis_ready_ = {};
  mutable std::array<AxisPyramid, kAxes> axes_;
};

/// Whether the plan cuts at a time, or stands still for it; else it is a rapid.
bool is_cutting(const Outcome& outcome, double time);

/// Of the blocks [first, last).
MotionExtent axis_extent_of_blocks(const Outcome& outcome, std::size_t first, std::size_t last, std::size_t axis);

/// Of an axis over the whole plan.
MotionExtent axis_whole(const ProfileSeries& series, std::size_t axis);

/// Pure and without a window: call it on the worker. Linear in phases and blocks.
std::shared_ptr<const ProfileSeries> make_profile_series(std::shared_ptr<const Outcome> outcome);

/// Makes what these axes take; from any thread.
void make_axes(const ProfileSeries& series, const ShownAxes& shown);
bool has_axes(const ProfileSeries& series, const ShownAxes& shown);

/// Extents of the phases [first, last) and of what the blocks [first, last) allow.
SplitExtent motion_extent(const Outcome& outcome, std::size_t first, std::size_t last);
CapExtent cap_extent(const Outcome& outcome, std::size_t first, std::size_t last);

}  // namespace toolpace::ui
