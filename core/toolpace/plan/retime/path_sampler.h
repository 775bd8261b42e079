#pragma once
/// What the axes do along a path, for planning: where on a curve a path length lies is good to about
/// a ten-thousandth of the piece.

#include <array>
#include <optional>

#include "toolpace/path/curve_sampler.h"

namespace toolpace::detail::retime {

/// Goes along a path, mostly forwards.
class PathSampler {
 public:
  /// @param begin  first segment; positions count from its start
  PathSampler(const Path& path, std::size_t begin);

  std::size_t segment() const { return segment_; }
  /// Position at which the present segment ends.
  double end() const { return start_ + path_.length[segment_]; }

  void go(double position);
  /// To the beginning of the next segment, of which there is one.
  void enter_next();
  /// To a place of the present segment; positions beyond its ends mean these.
  void go_inside(double position);

  /// Derivatives of the axes by path length at the place gone to.
  /// @tparam rows  axes: all, or X Y Z
  template <int rows>
  CurveDerivatives<rows> derivatives() const;

 private:
  void enter();
  void tabulate(std::size_t knots);
  ParameterDerivatives about_tip() const;
  double share() const;

  const Path& path_;
  std::size_t segment_;
  const Chain* chain_ = nullptr;  // about whose tip the segment is
  double start_ = 0, at_ = 0;     // of the segment; of the place, from there
  std::size_t knots_ = 0;         // of the table
  std::array<double, 9> length_;  // up to even shares of a curve's own parameter
  std::array<double, 9> speed_;   // length by share there
  ParameterDerivatives line_;
  std::optional<CurveSampler> curve_;
};

}  // namespace toolpace::detail::retime
