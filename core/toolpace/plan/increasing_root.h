#pragma once
/// Root of an increasing function inside a bracket, from the side where the function is not positive.

#include <cmath>

namespace toolpace::detail {

/// Largest x in [low, high] that the search finds with f(x) ≤ 0, where f increases, f(low) ≤ 0 < f(high).
///
/// Chandrupatla's method (bisection joined with inverse quadratic interpolation); at most 60 evaluations, and then the
/// answer is still one with f(x) ≤ 0. The bracket it stops at is 4e-16 of `high` wide.
/// @param at_low,at_high  f(low), f(high)
/// @source T. R. Chandrupatla 1997, Advances in Engineering Software 28, 145–149
template <class F>
double increasing_root(double low, double high, double at_low, double at_high, F&& f) {
  constexpr int kMaxEvaluations = 60;
  const double resolution = 4e-16 * high;
  double a = low, fa = at_low, b = high, fb = at_high;  // the last two points, of different sign
  double step = 0.5;
  for (int i = 0; i < kMaxEvaluations && fa != 0 && std::abs(b - a) > resolution; ++i) {
    const double x = a + step * (b - a);
    const double fx = f(x);
    double c = b, fc = fb;
    if ((fx > 0) == (fa > 0)) {
      c = a;
      fc = fa;
    } else {
      b = a;
      fb = fa;
    }
    a = x;
    fa = fx;
    const double xi = (a - b) / (c - b);
    const double phi = (fa - fb) / (fc - fb);
    step = 0.5;
    if (phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi) {
      step = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb);
    }
    // Never closer to an end than the resolution, or the bracket would not shrink from the other side.
    const double margin = 0.5 * resolution / std::abs(b - a);
    if (!(step > margin)) step = margin;
    if (!(step < 1 - margin)) step = 1 - margin;
  }
  if (fa <= 0) return a;
  return fb <= 0 ? b : low;
}

}  // namespace toolpace::detail
