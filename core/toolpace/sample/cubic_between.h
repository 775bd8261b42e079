#pragma once
/// What lies between rows that follow each other in one step of time.

#include <algorithm>
#include <cstddef>
#include <vector>

namespace toolpace {

/// A place between rows, and its change a row.
struct CubicPoint {
  double value, slope;
};

/// By the cubic through the four rows around (Lagrange): continuous, exact at the rows and for cubics. Before the first and
/// behind the last row it rests. @pre values is not empty
inline CubicPoint cubic_between(const std::vector<double>& values, double row) {
  const auto last = static_cast<std::ptrdiff_t>(values.size()) - 1;
  if (!(row > 0)) return {values.front(), 0};
  if (row >= static_cast<double>(last)) return {values.back(), 0};
  const auto k = static_cast<std::ptrdiff_t>(row);
  const double u = row - static_cast<double>(k);
  const auto at = [&](std::ptrdiff_t i) {
    return values[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, last))];
  };
  const double p0 = at(k - 1), p1 = at(k), p2 = at(k + 1), p3 = at(k + 2);
  // Newton's form from p1.
  const double d1 = p2 - p1, d2 = (p2 - 2 * p1 + p0) / 2, d3 = (p3 - 3 * p2 + 3 * p1 - p0) / 6;
  return {p1 + u * (d1 + (u - 1) * (d2 + (u + 1) * d3)), d1 + (2 * u - 1) * d2 + (3 * u * u - 1) * d3};
}

}  // namespace toolpace
