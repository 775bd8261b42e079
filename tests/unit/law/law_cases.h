#pragma once
/// Inputs that every law has to stand.

#include <limits>
#include <vector>

#include "toolpace/law/law_table.h"

namespace toolpace::testing {

struct RampCase {
  double v0, v1;
  RampLimits limits;
};

inline std::vector<RampCase> ramp_cases() {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  const std::vector<RampLimits> limits = {{3000, 1e6, 0.05}, {294.2, 3e4, 0.05}, {1e-3, 1e-2, 10},
                                          {1e6, 1e9, 1e-4},  {3000, kInf, 0.05}, {kInf, 1e6, 0.05}};
  const std::vector<double> speeds = {0, 1e-6, 0.5, 14.78, 100, 1e5};
  std::vector<RampCase> cases;
  for (const RampLimits& l : limits) {
    for (const double v0 : speeds) {
      for (const double v1 : speeds) cases.push_back({v0, v1, l});
    }
  }
  return cases;
}

}  // namespace toolpace::testing
