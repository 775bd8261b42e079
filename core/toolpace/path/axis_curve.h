#pragma once
/// What the axes do along a path: path ∘ chain, with three derivatives.
///
/// The one place where a path in the workpiece becomes a motion of axes. Limits, planners, timing, setpoints and travel ask it;
/// corners, tolerances, feeds and pictures are the path's own. Where the path is told by the axes themselves, it is the path, to the
/// bit.

#include "toolpace/path/path.h"

namespace toolpace {

/// A view of a path, which must outlive it. Lengths are the path's.
class AxisCurve {
 public:
  explicit AxisCurve(const Path& path) : path_(&path) {}

  const Path& path() const { return *path_; }

  /// Whether a segment is told by the axes themselves.
  bool is_path(std::size_t segment) const { return path_->chain_of(segment) == nullptr; }
  /// Whether no axis turns or changes its speed while the path is run at a constant one.
  bool is_straight(std::size_t segment) const;
  /// Whether a node, neither first nor last, lies inside what was programmed as one line or arc, which was cut for the axes' sake.
  bool is_cut(std::size_t node) const;

  /// As point_at() and frame_at() of the path: derivatives are by its length.
  AxisVector point_at(std::size_t segment, double s) const;
  Frame frame_at(std::size_t segment, double s) const;
  /// Where a segment begins and ends, in axes.
  AxisVector begin_of(std::size_t segment) const;
  AxisVector end_of(std::size_t segment) const;
  /// First derivatives at its ends.
  AxisVector start_direction(std::size_t segment) const;
  AxisVector end_direction(std::size_t segment) const;

  /// Axes that put the tip where a place on a segment tells it.
  AxisVector axes_of(std::size_t segment, const AxisVector& place) const;

 private:
  const Path* path_;
};

/// The axes' frame where tip and rotary axes have this one.
Frame through(const Chain& chain, const Frame& tip);

}  // namespace toolpace
