#pragma once
/// Numbers whose decimal digits stand in four bits each, as switches and displays have them: 0x1234 means 1234.

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace toolpace::nc {

inline constexpr double kMostBits = 4294967295.0;          ///< what 32 bits hold
inline constexpr double kLargestDecimalCode = 99999999.0;  ///< of eight digits

inline std::uint32_t bits_of(double value) { return static_cast<std::uint32_t>(std::clamp(value, 0.0, kMostBits)); }

/// The number that the digits of a code write.
inline double from_decimal_code(double code) {
  std::uint32_t bits = bits_of(code);
  double number = 0.0;
  for (double place = 1.0; bits != 0; bits >>= 4u, place *= 10.0) number += static_cast<double>(bits & 0xFu) * place;
  return number;
}

/// The code of a number; what is behind its point is left out.
inline double to_decimal_code(double number) {
  double digits = std::clamp(std::floor(number), 0.0, kLargestDecimalCode), code = 0.0;
  for (double place = 1.0; digits > 0.0; digits = std::floor(digits / 10.0), place *= 16.0)
    code += std::fmod(digits, 10.0) * place;
  return code;
}

}  // namespace toolpace::nc
