#pragma once
/// What length means where millimetres and degrees meet.

#include <cmath>

#include "toolpace/base/axis_unit.h"

namespace toolpace {

/// A value of an axis [mm, rad] as lengths count it [mm, deg]; the same for its derivatives by time.
constexpr double counted(std::size_t axis, double value) { return value / axis_unit(axis).size; }

/// Which axes a length is of.
///
/// Along a path it is that of X Y Z in mm; where none of them moves, that of A B C in degrees, so that a feed or a path limit
/// of 100 mm/s reads as 100 deg/s there, as controllers do it. Apart from a path (corners, tolerances, chord errors) both
/// count together, a degree as much as a millimetre.
class Metric {
 public:
  static constexpr Metric along(bool is_rotary_only) { return {!is_rotary_only, is_rotary_only}; }
  static constexpr Metric apart() { return {true, true}; }

  double norm(const AxisVector& v) const {
    if (!rotary_) return v.head<3>().norm();
    if (!linear_) return v.tail<3>().norm() / kRadiansPerDegree;
    return std::sqrt(squared_norm(v));
  }
  double squared_norm(const AxisVector& v) const { return dot(v, v); }
  double dot(const AxisVector& a, const AxisVector& b) const {
    const double linear = linear_ ? a.head<3>().dot(b.head<3>()) : 0.0;
    const double rotary = rotary_ ? a.tail<3>().dot(b.tail<3>()) : 0.0;
    return linear + rotary / (kRadiansPerDegree * kRadiansPerDegree);
  }

  bool operator==(const Metric&) const = default;

 private:
  constexpr Metric(bool linear, bool rotary) : linear_(linear), rotary_(rotary) {}
  bool linear_, rotary_;
};

}  // namespace toolpace
