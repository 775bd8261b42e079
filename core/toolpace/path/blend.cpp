#include "toolpace/path/blend.h"

#include <algorithm>

namespace toolpace {
namespace {

constexpr int kCornerPieces = 8;  // of a half, for quadrature: near a reversal the speed by the parameter dips
constexpr int kCurvePieces = 8;
constexpr int kNewtonSteps = 20;
constexpr double kParameterAccuracy = 1e-14;

/// ∫ |x′| from a to b, in pieces on a fixed grid so that partial lengths add up.
template <class Blend>
double length_between(const Blend& blend, double a, double b, double piece) {
  double sum = 0;
  while (a < b) {
    const double next = std::min(b, (std::floor(a / piece + 1e-9) + 1) * piece);
    sum += integrate([&](double t) { return blend_derivatives(blend, t).first.template head<3>().norm(); }, a, next);
    a = next;
  }
  return sum;
}

/// Parameter in 0 … top, the length up to `top` being `length`.
template <class Blend>
double solve_parameter(const Blend& blend, double piece, double top, double length, double s) {
  if (s <= 0) return 0;
  if (s >= length) return top;
  double low = 0, high = top, t = top * s / length;
  double at = 0, known = 0;  // length up to parameter `known`
  for (int i = 0; i < kNewtonSteps; ++i) {
    at = t >= known ? at + length_between(blend, known, t, piece) : at - length_between(blend, t, known, piece);
    known = t;
    (at < s ? low : high) = t;
    const double slope = blend_derivatives(blend, t).first.template head<3>().norm();
    double next = slope > 0 ? t + (s - at) / slope : (low + high) / 2;
    // Inside includes the ends: a step that rounding puts on a bracket's end has arrived there.
    if (!(next >= low && next <= high)) next = (low + high) / 2;
    if (std::abs(next - t) <= kParameterAccuracy * top) return next;
    t = next;
  }
  return t;
}

/// |after − before| / |before| = 2·sin(α/2): gentle corners need no subdivision.
double piece_of(const CornerBlend& blend) {
  const double turn = (blend.after - blend.before).head<3>().norm();
  return turn < 0.6 * blend.before.head<3>().norm() ? 0.5 : 0.5 / kCornerPieces;
}

}  // namespace

AxisVector blend_point(const CornerBlend& b, double t) {
  const double r = 1 - t;
  return b.corner - r * r * r * b.before + t * t * t * b.after;
}

ParameterDerivatives blend_derivatives(const CornerBlend& b, double t) {
  const double r = 1 - t;
  return {3 * (r * r * b.before + t * t * b.after), 6 * (t * b.after - r * b.before), 6 * (b.before + b.after)};
}

AxisVector blend_point(const CurveBlend& b, double t) {
  std::array<AxisVector, 6> p = b.points;
  for (std::size_t n = 5; n > 0; --n) {
    for (std::size_t i = 0; i < n; ++i) p[i] = (1 - t) * p[i] + t * p[i + 1];
  }
  return p[0];
}

ParameterDerivatives blend_derivatives(const CurveBlend& b, double t) {
  std::array<AxisVector, 6> p = b.points;
  for (std::size_t n = 5; n > 3; --n) {
    for (std::size_t i = 0; i < n; ++i) p[i] = (1 - t) * p[i] + t * p[i + 1];
  }
  // Four points are left: third differences, and the second and first after one and two more reductions.
  const AxisVector third = 60 * (p[3] - 3 * p[2] + 3 * p[1] - p[0]);
  for (std::size_t i = 0; i < 3; ++i) p[i] = (1 - t) * p[i] + t * p[i + 1];
  const AxisVector second = 20 * (p[2] - 2 * p[1] + p[0]);
  for (std::size_t i = 0; i < 2; ++i) p[i] = (1 - t) * p[i] + t * p[i + 1];
  return {5 * (p[1] - p[0]), second, third};
}

double blend_length(const CornerBlend& blend, double t) {
  const double piece = piece_of(blend);
  if (t >= 1) return 2 * length_between(blend, 0.0, 0.5, piece);
  return length_between(blend, 0.0, t, piece);
}

double blend_length(const CurveBlend& blend, double t) { return length_between(blend, 0.0, t, 1.0 / kCurvePieces); }

double blend_parameter(const CornerBlend& blend, double length, double s) {
  // The halves mirror each other.
  if (s > length / 2)
    return 1 - blend_parameter(CornerBlend{blend.corner, -blend.after, -blend.before}, length, length - s);
  return solve_parameter(blend, piece_of(blend), 0.5, length / 2, s);
}

double blend_parameter(const CurveBlend& blend, double length, double s) {
  return solve_parameter(blend, 1.0 / kCurvePieces, 1.0, length, s);
}

CurveBlend make_curve_blend(const BlendEnd& begin, const BlendEnd& end, double length) {
  const double l = length;
  CurveBlend b;
  b.points[0] = begin.point;
  b.points[1] = begin.point + (l / 5) * begin.first;
  b.points[2] = begin.point + (2 * l / 5) * begin.first + (l * l / 20) * begin.second;
  b.points[3] = end.point - (2 * l / 5) * end.first + (l * l / 20) * end.second;
  b.points[4] = end.point - (l / 5) * end.first;
  b.points[5] = end.point;
  return b;
}

}  // namespace toolpace
