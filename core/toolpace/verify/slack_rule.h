#pragma once
/// How far the path may be from the straight line between two setpoints, beyond the tolerance.

#include "toolpace/limits/machine.h"
#include "toolpace/path/path.h"
#include "toolpace/verify/path_follower.h"
#include "toolpace/verify/row_stream.h"

namespace toolpace {

/// An acceleration of A carries a motion off the chord between two setpoints by up to A·Ts²/8. Second differences beyond A·Ts²
/// say that the limit is broken there: then an eighth of them, and what they change by, unless speed is broken too, as where
/// rows are missing.
/// Around a corner that is passed with a step of speed it is no farther than the second differences at both ends of the chord
/// together, or than half the minor axis of the ellipse about the chord whose paths are as long as the way that the columns tell;
/// and never than that of the ellipse for the way that the machine's speed allows.
class SlackRule {
 public:
  /// @param period  [s]
  SlackRule(const Path& path, const Machine& machine, double period);

  /// Between the rows local − 1 and local. @param from_path  whether the first of them is on the path exactly
  Slack at(const RowStream& stream, std::size_t local, bool from_path) const;

 private:
  double period_;
  double speed_, acceleration_;  ///< [mm/s, mm/s²; deg] of all axes together
};

}  // namespace toolpace
