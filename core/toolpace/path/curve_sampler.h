#pragma once
/// Derivatives at many places of one curved segment.

#include "toolpace/path/path.h"

namespace toolpace {

/// Corner blends between lines, and splines without weights up to degree 3, are evaluated as the cubics that they are; other
/// curves by their own functions.
class CurveSampler {
 public:
  /// @param segment  a spline or blend
  CurveSampler(const Path& path, std::size_t segment);

  /// By path length, at a share 0 … 1 of the own parameter.
  /// @tparam rows  axes: all, or X Y Z
  template <int rows = static_cast<int>(kAxisCount)>
  CurveDerivatives<rows> at_share(double share) const {
    if (is_cubic_) {
      const CurveDerivatives<rows> d = cubic<rows>(share);
      if (d.first.template head<3>().norm() > least_speed_) return by_arc_length(d);
    }
    const ParameterDerivatives d = derivatives_at_share(*path_, segment_, share);
    return {d.first.template head<rows>(), d.second.template head<rows>(), d.third.template head<rows>()};
  }
  /// Length by that share [mm].
  double speed(double share) const;

 private:
  template <int rows>
  CurveDerivatives<rows> cubic(double share) const {
    const auto first = begin_.first.template head<rows>(), second = begin_.second.template head<rows>();
    const auto third = begin_.third.template head<rows>();
    return {first + share * (second + share / 2 * third), second + share * third, third};
  }

  const Path* path_;
  std::size_t segment_;
  bool is_cubic_ = false;
  double least_speed_;          // by share, at which the first derivative still tells the direction
  ParameterDerivatives begin_;  // by share, of cubics
};

}  // namespace toolpace
