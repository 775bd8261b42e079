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
  ParameterDerivatives at_share(double share) const;
  /// Length by that share [mm].
  double speed(double share) const;

 private:
  ParameterDerivatives cubic(double share) const;

  const Path* path_;
  std::size_t segment_;
  bool is_cubic_ = false;
  ParameterDerivatives begin_;  // by share, of cubics
};

}  // namespace toolpace
