#pragma once
/// MotionPlan + Path -> setpoints, as a stream.

#include <optional>

#include "toolpace/nc/moves.h"
#include "toolpace/path/path.h"
#include "toolpace/plan/motion_plan.h"
#include "toolpace/sample/chord_error.h"
#include "toolpace/sample/setpoints.h"

namespace toolpace {

/// Walks a plan at a constant period in bounded memory. Row k stands at t = k·period; the last row, at the first period
/// at or after the end, is the exact end of the path at rest. Positions are evaluated on the exact geometry and the
/// exact polynomials, never by integration, so no error accumulates.
///
/// Keeps references: path, plan and moves must outlive it.
class Sampler {
 public:
  /// @param period  [s] > 0
  Sampler(const Path& path, const MotionPlan& plan, const Moves& moves, double period);

  /// Rows in all.
  std::size_t rows() const { return rows_; }

  /// Replaces `chunk` by the next rows, at most `limit`. @return false, with an empty chunk, after the last row
  bool next(Setpoints& chunk, std::size_t limit = 65536);

  /// Measures, from here on, how far the chords between rows cut off the path. Costs about as much as sampling again.
  void measure_chords() { chords_.emplace(path_); }
  /// Largest so far [mm]; 0 where it was not measured.
  double largest_chord_error() const { return chords_ ? chords_->largest() : 0.0; }

  /// Goes on at this row. O(log phases + segments).
  void seek(std::size_t row);

 private:
  PhaseState state_at(double time);
  void write_row(Setpoints& chunk, std::size_t row, std::size_t at);
  void write(Setpoints& chunk, std::size_t at, const AxisVector& point, const PhaseState& state) const;
  const TimeSpline* spline_at(double time);
  void enter_segment(double distance);
  void load_segment();
  void hand_over(double s);

  const Path& path_;
  const MotionPlan& plan_;
  const Moves& moves_;
  double period_;
  std::size_t rows_ = 0;
  std::size_t next_row_ = 0;
  std::size_t phase_ = 0;
  std::size_t spline_ = 0;
  std::size_t segment_ = 0;
  std::size_t handover_ = 0;    ///< first one that is not passed yet
  double segment_begin_ = 0.0;  ///< path position of the segment's start
  AxisVector direction_ = AxisVector::Zero();
  std::uint32_t line_ = 0;
  bool rotary_;
  std::optional<ChordErrorMeter> chords_;
};

/// Number of rows that a motion of this duration has.
std::size_t row_count(double duration, double period);

}  // namespace toolpace
