#pragma once
/// Largest speed, acceleration and jerk of each axis, from differences of its setpoints.

#include <array>

#include "toolpace/sample/setpoints.h"

namespace toolpace {

struct AxisPeaks {
  double speed = 0, acceleration = 0, jerk = 0;  ///< [mm/s, mm/s², mm/s³ or rad …]
};

/// Takes chunks in order; the axes rest before the first row and after the last one.
class AxisPeakMeter {
 public:
  void add(const Setpoints& chunk);

  /// Goes on at the first row of a chunk, where every axis has moved uniformly since the row before.
  void resume(const Setpoints& chunk);

  /// Peaks of all rows so far, the rest after them included.
  std::array<AxisPeaks, kAxisCount> peaks() const;

  /// True for an axis that left its first position.
  bool has_moved(std::size_t axis) const { return axes_[axis].moved; }

 private:
  struct State {
    bool started = false, moved = false;
    double position = 0, speed = 0, acceleration = 0;
    AxisPeaks peaks;
    void step(double next, double period);
  };
  std::array<State, kAxisCount> axes_;
  double period_ = 0.001;
};

}  // namespace toolpace
