#pragma once
/// Acceleration and jerk along the path, from the positions alone.

#include "toolpace/verify/corner_exemption.h"
#include "toolpace/verify/path_worst.h"
#include "toolpace/verify/row_stream.h"

namespace toolpace {

/// The way of a period is the chord between its rows where the path is straight, and longer by at most a detour where it is
/// not: what a corner between two straight runs adds, or where the direction turns by φ from chord to chord, kDetour·φ²/8 of
/// the chord. (An arc has a third of φ²/8; but the rows do not tell how often a path of short blocks turns in between.) A
/// difference of chords that no detour explains proves a broken limit. A way that turns back by more than a right angle is not
/// run through at constant speed: what counts there is the whole change of velocity, less the step that the corner rule lets
/// pass.
class TangentCheck {
 public:
  /// @param period  [s]
  explicit TangentCheck(double period) : period_(period) {}

  /// Judges the rows of the window. @param noise  [mm] rounding of a position
  void take(const RowStream& stream, double noise, CornerExemption& corners, PathWorst& worst) const;

 private:
  double period_;
};

}  // namespace toolpace
