#pragma once
/// One block with constant acceleration: up, along, down.

#include <algorithm>
#include <cmath>

namespace toolpace::detail::controller {

/// Times of the three parts of a block [s].
struct Trapezoid {
  double up = 0, cruise = 0, down = 0;
  double entry = 0, peak = 0, exit = 0;  ///< [mm/s]
  bool has_plateau = false;              ///< the nominal speed is reached

  double total() const { return up + cruise + down; }
};

/// @param entry2, exit2, nominal2  squares of speeds [mm²/s²]; entry and exit are not above nominal, and reach each other
/// @param a  [mm/s²] > 0, up and down; length [mm] > 0
inline Trapezoid trapezoid(double entry2, double exit2, double nominal2, double a, double length) {
  Trapezoid t;
  const double peak2 = std::max({0.5 * (entry2 + exit2) + a * length, entry2, exit2});
  t.has_plateau = peak2 >= nominal2;
  const double top2 = std::min(peak2, nominal2);
  t.peak = std::sqrt(top2);
  t.entry = std::sqrt(entry2);
  t.exit = std::sqrt(exit2);
  t.up = std::max(0.0, t.peak - t.entry) / a;
  t.down = std::max(0.0, t.peak - t.exit) / a;
  if (t.has_plateau) t.cruise = std::max(0.0, length - (0.5 * (top2 - entry2) + 0.5 * (top2 - exit2)) / a) / t.peak;
  return t;
}

}  // namespace toolpace::detail::controller
