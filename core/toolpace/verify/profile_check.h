#pragma once
/// The columns: time, and speed, acceleration and jerk along the path against each other and the positions.

#include "toolpace/limits/machine.h"
#include "toolpace/verify/path_worst.h"
#include "toolpace/verify/report.h"
#include "toolpace/verify/row_stream.h"
#include "toolpace/verify/worst.h"

namespace toolpace {

/// Between two rows the way is  S = Ts/2·(v0+v1) + Ts²/12·(a0−a1), exact where the jerk is constant, and off by at most
/// Ts²/12·|Δa| + 0.0321·J·Ts³ where it changes in between (Peano kernel of the corrected trapezoidal rule). The chord
/// is S on straight stretches and shorter where the way turns, by an amount that the chords do not tell if it turns more than
/// once within a period: there it only must not be longer. In the same way
/// Ts/2·(a0+a1) gives the step of speed and Ts/2·(j0+j1) that of acceleration. Where the direction turns by θ,
/// the part of the acceleration vector A along the path changes by up to |A|·θ beside: that much is taken off (on smoothed
/// corners; on a circle of 25 mm at 100 mm/s it is 0.4 %). The largest disagreement is judged against these bounds.
class ProfileCheck {
 public:
  ProfileCheck(const Machine& machine, double period);

  /// @param worst  takes the columns' acceleration and jerk
  void take(const RowStream& stream, PathWorst& worst);
  void report(VerifyReport& report) const;

 private:
  void take_interval(const RowStream& stream, std::size_t i);
  void take_limits(const RowStream& stream, std::size_t i, PathWorst& worst);

  PathLimits limits_;
  double period_;
  bool has_time_ = false, has_profile_ = false;
  double first_time_ = 0.0, last_time_ = 0.0;
  Worst time_, chord_, speed_, acceleration_;
  double largest_ = 0.0;  ///< |acceleration|
  double largest_jerk_ = 0.0;
  double way_ = 0.0;
  double largest_speed_ = 0.0;
};

}  // namespace toolpace
