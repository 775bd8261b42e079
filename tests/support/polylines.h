#pragma once
/// Paths of straight lines that the literature and this project measure plans on.

#include <array>
#include <string>
#include <vector>

namespace toolpace::test {

struct Polyline {
  std::vector<std::array<double, 3>> points;  ///< [mm]
  std::vector<double> feed;                   ///< [mm/s] of the block that ends at the point; [0] leads nowhere
};

/// "line" and "circle" (5000 blocks of 0.02 mm, and of 0.1 mm on a radius of 25 mm), or a file of tests/data by its
/// name: "smooth" and "random" (5000 blocks of 0.05 … 0.5 mm), "butterfly588" and "blocks20_corners_a" (Ning et al. 2014).
/// Throws std::runtime_error where there is none.
Polyline polyline(const std::string& name);

}  // namespace toolpace::test
