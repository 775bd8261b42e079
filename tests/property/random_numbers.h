#pragma once
/// Random numbers of test cases.

#include <cmath>
#include <random>

namespace toolpace::testing {

using Random = std::mt19937_64;

inline double between(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// Between low and high, both > 0, with equal chances for each power of ten.
inline double spread(Random& random, double low, double high) {
  return std::exp(between(random, std::log(low), std::log(high)));
}

inline bool one_in(Random& random, unsigned n) { return random() % n == 0; }

}  // namespace toolpace::testing
