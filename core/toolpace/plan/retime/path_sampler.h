#pragma once
/// Derivatives along a path for planning: where on a curve a path length lies is good to about a hundredth of the piece.

#include "toolpace/path/path.h"

namespace toolpace::detail::retime {

/// Goes along a path, mostly forwards.
class PathSampler {
 public:
  /// @param begin  first segment; positions count from its start
  PathSampler(const Path& path, std::size_t begin);

  std::size_t segment() const { return segment_; }

  void go(double position);

  /// Derivatives by path length at the place gone to.
  ParameterDerivatives derivatives() const;

 private:
  void enter();
  double share() const;

  const Path& path_;
  std::size_t segment_;
  double start_ = 0, at_ = 0;               // of the segment; of the place, from there
  double begin_slope_ = 1, end_slope_ = 1;  // d share / d (s / length) at the segment's ends
  ParameterDerivatives line_;
};

}  // namespace toolpace::detail::retime
