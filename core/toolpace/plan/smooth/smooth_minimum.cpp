#include "toolpace/plan/smooth/smooth_minimum.h"

#include <algorithm>

namespace toolpace::detail::tube {
namespace {

/// out[k] = least of `values` over k ± reach (van Herk's blocks: linear time).
void running_minimum(const std::vector<double>& values, std::size_t reach, std::vector<double>& out) {
  const std::size_t n = values.size(), width = 2 * reach + 1, padded = n + 2 * reach;
  const auto value = [&](std::size_t q) { return q < reach || q - reach >= n ? 1.0 : values[q - reach]; };
  std::vector<double> forward(padded), backward(padded);
  for (std::size_t q = 0; q < padded; ++q) {
    forward[q] = q % width == 0 ? value(q) : std::min(forward[q - 1], value(q));
  }
  for (std::size_t q = padded; q-- > 0;) {
    backward[q] = q + 1 == padded || q % width == width - 1 ? value(q) : std::min(backward[q + 1], value(q));
  }
  out.resize(n);
  for (std::size_t k = 0; k < n; ++k) out[k] = std::min(backward[k], forward[k + width - 1]);
}

void running_mean(const std::vector<double>& values, std::size_t half, std::vector<double>& out) {
  const std::size_t n = values.size();
  const auto value = [&](std::size_t q) { return values[q < half ? 0 : std::min(n - 1, q - half)]; };
  out.resize(n);
  double sum = 0;
  for (std::size_t q = 0; q < 2 * half + 1; ++q) sum += value(q);
  for (std::size_t k = 0; k < n; ++k) {
    out[k] = std::clamp(sum / static_cast<double>(2 * half + 1), 0.0, 1.0);
    sum += value(k + 2 * half + 1) - value(k);
  }
}

}  // namespace

void smooth_minimum(std::vector<double>& values, std::size_t reach, std::vector<double>& scratch) {
  if (values.empty()) return;
  running_minimum(values, reach, scratch);
  running_mean(scratch, reach / 3, values);
  running_mean(values, reach / 3, scratch);
  running_mean(scratch, reach / 3, values);
}

}  // namespace toolpace::detail::tube
