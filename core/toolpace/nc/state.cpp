#include "toolpace/nc/state.h"

#include <cmath>

namespace toolpace::nc {

Position to_machine(const Offsets& offsets, const Position& work) {
  Position p;
  if (offsets.is_scaled) {
    const Scaling& scaling = offsets.scaling;
    for (std::size_t i = 0; i < kAxisCount; ++i)
      p[i] = work[i] * scaling.factor[i] + scaling.offset[i] + offsets.shift[i];
  } else {
    for (std::size_t i = 0; i < kAxisCount; ++i) p[i] = work[i] + offsets.shift[i];
  }
  if (offsets.rotation != 0.0) {
    const double c = std::cos(offsets.rotation * kRadiansPerDegree);
    const double s = std::sin(offsets.rotation * kRadiansPerDegree);
    const double x = p[0];
    p[0] = x * c - p[1] * s;
    p[1] = x * s + p[1] * c;
  }
  for (std::size_t i = 0; i < kAxisCount; ++i) p[i] += offsets.origin[i] + offsets.tool_length[i];
  return p;
}

Position to_work(const Offsets& offsets, const Position& machine) {
  Position p;
  for (std::size_t i = 0; i < kAxisCount; ++i) p[i] = machine[i] - offsets.origin[i] - offsets.tool_length[i];
  if (offsets.rotation != 0.0) {
    const double c = std::cos(offsets.rotation * kRadiansPerDegree);
    const double s = std::sin(offsets.rotation * kRadiansPerDegree);
    const double x = p[0];
    p[0] = x * c + p[1] * s;
    p[1] = -x * s + p[1] * c;
  }
  for (std::size_t i = 0; i < kAxisCount; ++i) p[i] -= offsets.shift[i];
  if (offsets.is_scaled) {
    const Scaling& scaling = offsets.scaling;
    for (std::size_t i = 0; i < kAxisCount; ++i) p[i] = (p[i] - scaling.offset[i]) / scaling.factor[i];
  }
  return p;
}

}  // namespace toolpace::nc
