#pragma once
/// Corner curves cut in two, so that each half can be commanded by itself.

#include <array>

#include "toolpace/path/blend.h"

namespace toolpace {

/// The same curve, as one of degree 5.
inline CurveBlend as_curve_blend(const CornerBlend& blend) {
  CurveBlend curve;
  auto& p = curve.points;
  p[0] = blend.corner - blend.before;
  p[1] = p[2] = blend.corner;
  p[3] = blend.corner + blend.after;
  // The degree is raised twice, with one point more each time.
  for (std::size_t n = 4; n <= 5; ++n) {
    p[n] = p[n - 1];
    for (std::size_t i = n - 1; i > 0; --i) {
      const double share = static_cast<double>(i) / static_cast<double>(n);
      p[i] = share * p[i - 1] + (1 - share) * p[i];
    }
  }
  return curve;
}

/// The parts before and after t = 1/2.
inline std::array<CurveBlend, 2> halves(const CurveBlend& blend) {
  std::array<CurveBlend, 2> half;
  std::array<AxisVector, 6> p = blend.points;
  for (std::size_t n = 5;; --n) {  // de Casteljau
    half[0].points[5 - n] = p[0];
    half[1].points[n] = p[n];
    if (n == 0) return half;
    for (std::size_t i = 0; i < n; ++i) p[i] = (p[i] + p[i + 1]) / 2;
  }
}

}  // namespace toolpace
