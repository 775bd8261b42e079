#pragma once
/// How many random cases a test tries.

#include <cstddef>
#include <cstdlib>

namespace toolpace::test {

/// `usual` cases, times TOOLPACE_CASES_FACTOR where scripts/soak sets it.
inline std::size_t case_count(std::size_t usual) {
  const char* factor = std::getenv("TOOLPACE_CASES_FACTOR");
  const double value = factor ? std::atof(factor) : 1.0;
  return value > 0 ? static_cast<std::size_t>(static_cast<double>(usual) * value) : usual;
}

}  // namespace toolpace::test
