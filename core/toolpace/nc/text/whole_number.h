#pragma once
/// Words that count something.

#include <cmath>
#include <optional>

namespace toolpace::nc {

inline constexpr int kMostCalls = 999'999'999;  ///< of a sub-program by one L

/// `value` as a whole number from `low` to `high`, to 1e-3; none if it is no such number (NaN is none).
inline std::optional<int> whole_number(double value, int low, int high) {
  constexpr double kWithin = 1e-3;
  if (!(value >= low - kWithin && value <= high + kWithin)) return std::nullopt;
  const double whole = std::round(value);
  if (std::fabs(value - whole) > kWithin) return std::nullopt;
  return static_cast<int>(whole);
}

}  // namespace toolpace::nc
