#include "toolpace/path/curve_sampler.h"

namespace toolpace {
namespace {

constexpr double kNoSpeed = 1e-6;  // of the mean: there the direction is not where the first derivative points

}  // namespace

CurveSampler::CurveSampler(const Path& path, std::size_t segment)
    : path_(&path), segment_(segment), least_speed_(kNoSpeed * path.length[segment]) {
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

double CurveSampler::speed(double share) const {
  return is_cubic_ ? cubic<3>(share).first.norm() : parameter_speed(*path_, segment_, share);
}

}  // namespace toolpace
