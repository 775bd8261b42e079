#pragma once
/// How large a step of speed a corner rule lets pass.

#include <optional>

#include "toolpace/limits/corner_rule.h"
#include "toolpace/limits/machine.h"

namespace toolpace {

/// The rows around a corner, seen from it.
struct CornerRun {
  AxisVector arriving, leaving;  ///< change of the axes by length of path [1, rad/mm; rad/deg]
  double before, after;          ///< way of the period before and after it [mm; deg]
  bool is_straight = false;      ///< whether both ways are known to be straight, and so as long as the rows are apart
};

/// What a corner may have been passed at, at most.
struct CornerPassage {
  double speed;         ///< [mm/s; deg/s]
  double acceleration;  ///< along the path [mm/s²; deg/s²]
};

/// A step of direction at constant speed is an acceleration across the way, which nothing else can tell from a broken
/// limit: up to what the corner rule lets pass, corners are exempt by it.
class CornerLimit {
 public:
  /// @param rule  of the job; none = not known
  CornerLimit(const Machine& machine, const std::optional<CornerOptions>& rule) : machine_(machine), rule_(rule) {}

  /// The speed at a corner is between the mean speeds around it, but for what changes in a period (on straight ways no more than
  /// a few periods at the largest acceleration bring), and no more than its rule lets pass.
  ///
  /// @param period  [s]
  /// @param rule    of this corner; none = not known, as under rules that smooth corners. Then a turn of up to a right angle may
  ///                be passed at any speed, and one that turns back as the servo rule or a wide junction deviation would let it
  CornerPassage passage(const CornerRun& run, double period, const std::optional<CornerOptions>& rule) const;

  /// Of the job.
  const std::optional<CornerOptions>& rule() const { return rule_; }

 private:
  double speed(const CornerRun& run, const std::optional<CornerOptions>& rule) const;
  double acceleration_along(const AxisVector& direction) const;

  Machine machine_;
  std::optional<CornerOptions> rule_;
};

}  // namespace toolpace
