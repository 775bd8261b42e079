#pragma once
/// A smooth curve under a rough one.

#include <cstddef>
#include <vector>

namespace toolpace::detail::tube {

/// Replaces values of 0 … 1 by a sequence that is nowhere above them: the minimum over ±reach, then three running means
/// that together reach as far, so that its differences up to the third are small. Linear time.
void smooth_minimum(std::vector<double>& values, std::size_t reach, std::vector<double>& scratch);

}  // namespace toolpace::detail::tube
