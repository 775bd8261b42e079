#pragma once
/// How far the straight lines between setpoints cut off the path.

#include <optional>

#include "toolpace/path/axis_curve.h"

namespace toolpace {

/// Takes the setpoints of a path in order and keeps the largest distance between the path and the chord from one setpoint to
/// the next: nodes that lie between them exactly, curves by their middle (sagitta, exact to the fourth power of the chord).
class ChordErrorMeter {
 public:
  explicit ChordErrorMeter(const Path& path);

  /// Next setpoint: `s` along `segment`, at a place as the path tells it.
  void add(std::size_t segment, double s, const AxisVector& place);

  double largest() const { return largest_; }  ///< [mm, deg]

 private:
  void compare(const AxisVector& on_path, const AxisVector& place);
  void compare_curve(std::size_t segment, double begin, double end, const AxisVector& place);
  double length_to(std::size_t segment, double s) const;
  /// Where no axis turns, a path of some length between two setpoints leaves their chord by √(length² − chord²)/2 at most.
  bool may_be_larger(std::size_t segment, double s, const AxisVector& place) const;
  void find_middle(std::size_t segment, const AxisVector& place);

  const Path& path_;
  AxisCurve curve_;
  bool turns_;  ///< so that lengths do not count all that moves
  bool started_ = false;
  std::size_t segment_ = 0;
  double s_ = 0.0;
  AxisVector point_ = AxisVector::Zero();
  std::optional<AxisVector> middle_;  ///< of the chord to the next setpoint, where the axes carry the tip
  double largest_ = 0.0;
};

}  // namespace toolpace
