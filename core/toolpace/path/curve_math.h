#pragma once
/// Small maths that all curves share: quadrature, and derivatives by arc length from derivatives by a parameter.

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>

#include "toolpace/base/axes.h"

namespace toolpace {

/// Eight-point Gauss-Legendre rule on [a, b]; exact for polynomials of degree 15.
template <class F>
double integrate(const F& f, double a, double b) {
  constexpr std::array<double, 4> x = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
  constexpr std::array<double, 4> w = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
  const double centre = (a + b) / 2, half = (b - a) / 2;
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += w[i] * (f(centre - half * x[i]) + f(centre + half * x[i]));
  return half * sum;
}

/// Derivatives of a curve by its own parameter.
/// @tparam rows  axes: all, or X Y Z
template <int rows>
struct CurveDerivatives {
  Eigen::Matrix<double, rows, 1> first, second, third;
};
using ParameterDerivatives = CurveDerivatives<static_cast<int>(kAxisCount)>;

/// The same derivatives by arc length of the XYZ part (chain rule with g = |p'|, s' = g).
/// @param p  first.head<3>() must not be zero
template <int rows>
CurveDerivatives<rows> by_arc_length(const CurveDerivatives<rows>& p) {
  const auto p1 = p.first.template head<3>(), p2 = p.second.template head<3>(), p3 = p.third.template head<3>();
  const double g = p1.norm();
  const double w1 = 1 / g;
  const double g1 = p1.dot(p2) * w1;
  const double g2 = (p2.dot(p2) + p1.dot(p3) - g1 * g1) * w1;
  const double w2 = -g1 * w1 * w1 * w1;
  const double w3 = (3 * g1 * g1 * w1 - g2) * w1 * w1 * w1 * w1;
  return {p.first * w1, p.second * (w1 * w1) + p.first * w2,
          p.third * (w1 * w1 * w1) + p.second * (3 * w1 * w2) + p.first * w3};
}

}  // namespace toolpace
