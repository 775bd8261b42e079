#include "toolpace/limits/curve_axes.h"

#include <algorithm>

#include "toolpace/base/axis_unit.h"

namespace toolpace {

std::array<AxisLimits, kAxisCount> curve_axes(const Machine& machine, bool keeps_jerk) {
  const auto shared = [](std::size_t axis, double own, double along) {
    if (!is_rotary(axis)) return std::min(own, along);
    return own < kUnlimited ? own : along * axis_unit(axis).size;
  };
  auto axes = machine.axes;
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    axes[k].acceleration = shared(k, axes[k].acceleration, machine.path.acceleration);
    axes[k].jerk = keeps_jerk ? shared(k, axes[k].jerk, machine.path.jerk) : kUnlimited;
  }
  return axes;
}

}  // namespace toolpace
