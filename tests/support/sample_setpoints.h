#pragma once
/// Setpoints for tests of formats: values with all the digits a double has.

#include <cmath>

#include "toolpace/sample/setpoints.h"

namespace toolpace::testing {

inline Setpoints sample_setpoints(std::size_t first, std::size_t rows, bool rotary = false) {
  Setpoints s;
  s.first_row = first;
  s.period = 0.001;
  for (std::size_t k = first; k < first + rows; ++k) {
    const double t = static_cast<double>(k);
    s.position[0].push_back(100 * std::sin(t / 300));
    s.position[1].push_back(100 * std::cos(t / 300));
    s.position[2].push_back(-5.0);
    if (rotary) s.position[4].push_back(std::sin(t / 700));
    s.speed.push_back(50 + std::sin(t / 100));
    s.acceleration.push_back(10 * std::cos(t / 100));
    s.jerk.push_back(-1000 * std::sin(t / 100) / 3);
    s.line.push_back(static_cast<std::uint32_t>(k / 7 + 1));
  }
  return s;
}

}  // namespace toolpace::testing
