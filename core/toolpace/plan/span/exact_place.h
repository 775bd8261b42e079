#pragma once
/// Places along a stretch, for ways between them that are far from its start.

#include <cstddef>
#include <vector>

namespace toolpace::detail {

/// A place to twice the digits of a double: a bridge of a micrometre behind a stroke of a metre is as exact as one alone.
struct ExactPlace {
  double high = 0.0, low = 0.0;  ///< their sum [mm]

  friend ExactPlace operator+(const ExactPlace& p, double way) {
    const double sum = p.high + way, added = sum - p.high;
    const double error = ((p.high - (sum - added)) + (way - added)) + p.low, high = sum + error;
    return {high, error - (high - sum)};
  }
  friend ExactPlace operator-(const ExactPlace& p, double way) { return p + -way; }
  /// The way from b to a.
  friend double operator-(const ExactPlace& a, const ExactPlace& b) { return (a.high - b.high) + (a.low - b.low); }
  friend bool operator==(const ExactPlace& a, const ExactPlace& b) { return a - b == 0; }
  friend bool operator<(const ExactPlace& a, const ExactPlace& b) { return a - b < 0; }
  friend bool operator>(const ExactPlace& a, const ExactPlace& b) { return a - b > 0; }
  friend bool operator<=(const ExactPlace& a, const ExactPlace& b) { return a - b <= 0; }
  friend bool operator>=(const ExactPlace& a, const ExactPlace& b) { return a - b >= 0; }
};

/// Places of the nodes first … last counted from the first of them, written at their indices.
inline void sum_lengths(const std::vector<double>& lengths, std::size_t first, std::size_t last,
                        std::vector<ExactPlace>& place) {
  place[first] = {};
  for (std::size_t i = first; i < last; ++i) place[i + 1] = place[i] + lengths[i];
}

}  // namespace toolpace::detail
