#include "toolpace/path/curve_sampler.h"

namespace toolpace {
namespace {

constexpr double kNoSpeed = 1e-6;  // of the mean: there the direction is not where the first derivative points

}  // namespace

CurveSampler::CurveSampler(const Path& path, std::size_t segment) : path_(&path), segment_(segment) {
  const std::uint32_t detail = path.detail[segment];
  if (path.kind[segment] == SegmentKind::spline) {
    const SplinePiece& piece = path.spline_pieces[detail];
    const SplineCurve& curve = path.splines[piece.spline];
    if (curve.degree > 3 || !curve.is_polynomial) return;
    const double width = piece.end - piece.begin;
    begin_ = spline_derivatives(curve, piece, piece.begin);
    begin_.first *= width;
    begin_.second *= width * width;
    begin_.third *= width * width * width;
  } else if (detail < Path::kCurveBlend) {
    begin_ = blend_derivatives(path.corner_blends[detail], 0.0);
  } else {
    return;
  }
  is_cubic_ = true;
}

ParameterDerivatives CurveSampler::cubic(double share) const {
  return {begin_.first + share * (begin_.second + share / 2 * begin_.third), begin_.second + share * begin_.third,
          begin_.third};
}

ParameterDerivatives CurveSampler::at_share(double share) const {
  if (is_cubic_) {
    const ParameterDerivatives d = cubic(share);
    if (d.first.head<3>().norm() > kNoSpeed * path_->length[segment_]) return by_arc_length(d);
  }
  return derivatives_at_share(*path_, segment_, share);
}

double CurveSampler::speed(double share) const {
  return is_cubic_ ? cubic(share).first.head<3>().norm() : parameter_speed(*path_, segment_, share);
}

}  // namespace toolpace
