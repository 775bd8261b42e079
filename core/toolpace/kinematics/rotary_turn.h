#pragma once
/// Rotary axes that turn by polynomials.

#include "toolpace/kinematics/chain.h"

namespace toolpace {

/// A, B, C [rad] and their first two derivatives by some length.
struct RotaryPlace {
  Eigen::Vector3d angle, first, second;
};

/// A, B, C as polynomials of degree 5 of a length s.
struct RotaryTurn {
  std::array<Eigen::Vector3d, 6> coefficients;  ///< by powers of (begin + s)/scale [rad]
  double begin = 0.0;                           ///< [mm; deg]
  double scale = 1.0;                           ///< [mm; deg] > 0

  Derivatives<Eigen::Vector3d> at(double s) const;
};

/// The one that has these places at its two ends.
/// @param length  > 0, of which both places tell their derivatives
RotaryTurn turn_between(const RotaryPlace& from, const RotaryPlace& to, double length);

}  // namespace toolpace
