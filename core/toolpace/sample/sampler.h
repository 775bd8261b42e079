#pragma once
/// MotionPlan + Path -> setpoints, as a stream.

#include <algorithm>
#include <optional>
#include <vector>

#include "toolpace/nc/moves.h"
#include "toolpace/sample/chord_error.h"
#include "toolpace/sample/motion.h"
#include "toolpace/sample/setpoints.h"
#include "toolpace/sample/shaper.h"

namespace toolpace {

/// Walks a motion at a constant period in bounded memory. Row k stands at t = k·period; the last row, at the first period
/// at or after the end, is the exact end of the path at rest.
///
/// Shaped, each row is the mean of the motion at some earlier times (shaper.h), the columns along the way are those of the way that is
/// then run, and the line is the one that the mean of these times lies on.
///
/// Keeps references: path, plan and moves must outlive it.
class Sampler {
 public:
  /// @param period  [s] > 0
  Sampler(const Path& path, const MotionPlan& plan, const Moves& moves, double period,
          const Impulses& impulses = {{0, 1}});

  /// Rows in all.
  std::size_t rows() const { return rows_; }

  /// Replaces `chunk` by the next rows, at most `limit`. @return false, with an empty chunk, after the last row
  bool next(Setpoints& chunk, std::size_t limit = 65536);

  bool is_shaped() const { return !echoes_.empty(); }
  /// How far shaped rows were from the planned motion at the most so far, across its way [mm; a degree as one].
  double largest_offset() const { return largest_offset_; }

  /// Measures, from here on, how far the chords between rows cut off the path, where the rows lie on it: not of shaped ones. Costs about
  /// as much as sampling again.
  void measure_chords() { chords_.emplace(path_); }
  /// Largest so far [mm]; 0 where it was not measured.
  double largest_chord_error() const { return chords_ ? chords_->largest() : 0.0; }

  /// Goes on at this row.
  void seek(std::size_t row) { next_row_ = std::min(row, rows_); }

 private:
  /// The motion at one impulse.
  struct Echo {
    Impulse impulse;
    Motion motion;
  };
  void write_row(Setpoints& chunk, std::size_t row, std::size_t at);
  void write_shaped_row(Setpoints& chunk, std::size_t row, std::size_t at);
  AxisMotion mean_at(double time);
  void write_names(Setpoints& chunk, std::size_t at);

  const Path& path_;
  const Moves& moves_;
  Motion motion_;
  double period_;
  std::size_t rows_;
  std::size_t next_row_ = 0;
  bool rotary_;
  std::optional<double> tool_length_;  // as the program has told it last, or will tell it
  std::vector<Echo> echoes_;           // none where nothing is shaped
  double delay_ = 0;                   // mean of the impulses' times
  double largest_offset_ = 0;
  std::optional<ChordErrorMeter> chords_;
};

/// Number of rows that a motion of this duration has.
std::size_t row_count(double duration, double period);

}  // namespace toolpace
