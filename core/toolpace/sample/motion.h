#pragma once
/// Path + plan: where a machine is at any time, and how it moves there.

#include <cstdint>
#include <optional>

#include "toolpace/law/phase_bounds.h"
#include "toolpace/path/axis_curve.h"
#include "toolpace/path/piece_walker.h"
#include "toolpace/plan/motion_plan.h"

namespace toolpace {

/// A planned motion as one function of time, on the exact geometry and the exact polynomials: nothing is integrated and
/// nothing differenced, so no error accumulates.
///
/// It is asked for one instant after another, and keeps the place of the last one: times that rise step by step cost O(1)
/// each, others O(log phases + log segments). Copies are cheap and have a place of their own, so each thread takes one. Keeps
/// references: path and plan must outlive it.
class Motion {
 public:
  /// @pre path.node is not empty
  Motion(const Path& path, const MotionPlan& plan) : path_(path), curve_(path), plan_(plan) {}

  /// [s]
  double duration() const { return plan_.cycle_time(); }

  /// Goes to an instant; the time is held between 0 and duration(), whose place is the end of the path, to the bit.
  Motion& at(double time);
  /// The same as an instant of this segment: where it stands at one of its nodes, on its side of it.
  Motion& at(double time, std::size_t segment);

  /// When it comes to a path position, and has rested there [s].
  double time_at(double position);

  // Of the instant gone to:

  /// Path position, and speed, acceleration and jerk along the way that is really run [mm, s; deg where only rotary axes
  /// move]. At the seam of two phases those of the later one.
  const PhaseState& along() const { return along_; }
  /// Segment of the path under the tool, and how far it has come in it: path length from the segment's start.
  std::size_t segment() const { return segment_; }
  double on_segment() const { return on_segment_; }
  /// Row of Moves under the tool.
  std::uint32_t move();
  /// Phase of the plan.
  std::size_t phase() const { return phase_; }
  /// Whether it runs beside the path, as a spline of the plan, and not on it.
  bool leaves_path() const { return spline_ != nullptr; }

  /// Of the axes [mm, rad]
  AxisVector position();
  /// Of what the path tells: the tip in the workpiece beside the rotary axes, or the axes themselves [mm, rad].
  AxisVector place();
  /// Of each axis. Exact but for rounding, and for what frame_at() says of curves.
  AxisMotion axes();

  // Least and greatest values between two times, 0 ≤ begin ≤ end ≤ duration(). The instant gone to is lost.

  /// Along the way that is really run. Exact on the path; beside it of instants, four in each knot interval of a spline.
  PhaseBounds bounds(double begin, double end);
  /// Of one axis [mm, rad]. Exact on lines and beside the path; on curves of eight instants in each phase of each segment.
  PhaseBounds bounds(double begin, double end, std::size_t axis);

 private:
  struct Part;
  static inline const AxisVector kNowhere = AxisVector::Zero();

  std::size_t phase_at(double time) const;
  const TimeSpline* spline_at(double time);
  void find_segment(bool goes_on);
  void enter(std::size_t segment);
  const AxisVector& direction();
  const PieceWalker& walker();
  template <class Add>
  void for_each_part(double begin, double end, const Add& add);
  void add_on_path(const Part& part, std::size_t axis, PhaseBounds& box);
  void add_on_segment(const Part& part, std::size_t axis, PhaseBounds& box);

  const Path& path_;
  AxisCurve curve_;
  const MotionPlan& plan_;
  // Of the instant gone to; the indices are where the next search begins.
  double time_ = 0;
  PhaseState along_ = {};
  std::size_t node_ = 0;  ///< of its phase
  double from_node_ = 0, on_segment_ = 0;
  const TimeSpline* spline_ = nullptr;
  AxisMotion beside_ = {kNowhere, kNowhere, kNowhere, kNowhere};  ///< on that spline
  std::size_t phase_ = 0, arriving_ = 0, last_spline_ = 0, segment_ = 0, handover_ = 0;
  std::size_t line_ = static_cast<std::size_t>(-1);  ///< segment of direction_
  AxisVector direction_ = kNowhere;
  std::size_t walked_ = static_cast<std::size_t>(-1);  ///< segment of walker_
  std::optional<PieceWalker> walker_;
};

}  // namespace toolpace
