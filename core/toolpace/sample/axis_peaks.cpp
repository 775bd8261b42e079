#include "toolpace/sample/axis_peaks.h"

#include <algorithm>
#include <cmath>

namespace toolpace {

void AxisPeakMeter::State::step(double next, double period) {
  if (!started) {
    started = true;
    position = next;
    return;
  }
  moved |= next != position;
  const double new_speed = (next - position) / period;
  const double new_acceleration = (new_speed - speed) / period;
  const double jerk = (new_acceleration - acceleration) / period;
  peaks.speed = std::max(peaks.speed, std::abs(new_speed));
  peaks.acceleration = std::max(peaks.acceleration, std::abs(new_acceleration));
  peaks.jerk = std::max(peaks.jerk, std::abs(jerk));
  position = next;
  speed = new_speed;
  acceleration = new_acceleration;
}

void AxisPeakMeter::add(const Setpoints& chunk) {
  period_ = chunk.period;
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    for (const double position : chunk.position[k]) axes_[k].step(position, period_);
  }
}

void AxisPeakMeter::resume(const Setpoints& chunk) {
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    if (!chunk.position[k].empty()) axes_[k].position = chunk.position[k].front();
  }
}

std::array<AxisPeaks, kAxisCount> AxisPeakMeter::peaks() const {
  std::array<AxisPeaks, kAxisCount> result;
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    State rest = axes_[k];
    for (int i = 0; i < 3; ++i) rest.step(rest.position, period_);
    result[k] = rest.peaks;
  }
  return result;
}

}  // namespace toolpace
