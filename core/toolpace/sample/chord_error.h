#pragma once
/// How far the straight lines between setpoints cut off the path.

#include "toolpace/path/path.h"

namespace toolpace {

/// Takes the setpoints of a path in order and keeps the largest distance between the path and the chord from one setpoint to
/// the next: nodes that lie between them exactly, curves by their middle (sagitta, exact to the fourth power of the chord).
class ChordErrorMeter {
 public:
  explicit ChordErrorMeter(const Path& path) : path_(path) {}

  /// Next setpoint: `s` along `segment`.
  void add(std::size_t segment, double s, const AxisVector& point);

  double largest() const { return largest_; }  ///< [mm, deg]

 private:
  void compare(const AxisVector& on_path, const AxisVector& chord_begin, const AxisVector& chord_end);
  void compare_curve(std::size_t segment, double begin, double end, const AxisVector& from, const AxisVector& to);

  const Path& path_;
  bool started_ = false;
  std::size_t segment_ = 0;
  double s_ = 0.0;
  AxisVector point_ = AxisVector::Zero();
  double largest_ = 0.0;
};

}  // namespace toolpace
