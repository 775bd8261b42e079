#pragma once
/// Chains of the usual builds, for tests.

#include <cmath>

#include "toolpace/kinematics/chain.h"

namespace toolpace::testing {

inline constexpr std::size_t kA = 3, kB = 4, kC = 5;

inline AxisVector axes(double x, double y, double z, double a = 0, double b = 0, double c = 0) {
  AxisVector v;
  v << x, y, z, a * kRadiansPerDegree, b * kRadiansPerDegree, c * kRadiansPerDegree;
  return v;
}

/// A carries C, both under the workpiece.
inline Chain trunnion() {
  return {{{kA, ChainSide::table, Eigen::Vector3d::UnitX(), {0, 0, -50}},
           {kC, ChainSide::table, Eigen::Vector3d::UnitZ(), {10, 20, 0}}},
          100};
}

/// B carries the spindle, C the workpiece.
inline Chain head_and_table() {
  return {{{kB, ChainSide::head, Eigen::Vector3d::UnitY(), {0, 0, 30}},
           {kC, ChainSide::table, Eigen::Vector3d::UnitZ(), {0, 0, 0}}},
          100};
}

/// C carries a B that is inclined by 45°, which carries the spindle.
inline Chain nutating_head() {
  return {{{kC, ChainSide::head, Eigen::Vector3d::UnitZ(), {0, 0, 0}},
           {kB, ChainSide::head, Eigen::Vector3d(0, 1, 1).normalized(), {0, 0, 0}}},
          100};
}

}  // namespace toolpace::testing
