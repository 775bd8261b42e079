#pragma once
/// The same motion on longer and shorter steps: most of the way to the fastest motion is gone where steps are few.

#include "toolpace/plan/smooth/motion_window.h"
#include "toolpace/plan/smooth/step_limits.h"

namespace toolpace::detail::tube {

/// A motion on steps `by` times as long, near the given one. Where it begins and ends in motion place, speed and
/// acceleration stay; in between it loses as much time as a whole number of steps wants, less than one.
template <int D>
MotionWindow<D> coarsened(const MotionWindow<D>& m, std::size_t by) {
  using Vec = typename MotionWindow<D>::Vec;
  const double r = static_cast<double>(by), length = static_cast<double>(m.size()) - 3;
  const double cells = std::max(std::ceil(length / r), 4.0), spare = r * cells - length;
  // u = 1 + r·τ − spare·σ(τ/cells), σ(x) = 10x³ − 15x⁴ + 6x⁵
  const auto place = [&](double x) { return 1 + r * cells * x - spare * x * x * x * (10 - 15 * x + 6 * x * x); };
  MotionWindow<D> out;
  out.first = m.first;
  out.rest_begin = m.rest_begin;
  out.rest_end = m.rest_end;
  out.stride = m.stride * by;
  const auto n = static_cast<std::size_t>(cells) + 3;
  out.c.resize(n);
  for (std::size_t j = 1; j + 1 < n; ++j) {
    const double x = (static_cast<double>(j) - 1) / cells, y = 1 - x;
    const double rate = r - spare / cells * 30 * x * x * y * y;
    const double gain = -spare / (cells * cells) * 60 * x * y * (1 - 2 * x);
    double t;
    const std::size_t k = m.cell(place(x), t);
    out.c[j] = m.combine(k, basis(t)) -
               (m.combine(k, basis_bend(t)) * (rate * rate) + m.combine(k, basis_slope(t)) * gain) / 6;
  }
  const auto set_end = [&](std::size_t k, double t, double sign, auto at) {
    const Vec v = m.combine(k, basis_slope(t)) * (sign * r), a = m.combine(k, basis_bend(t)) * (r * r);
    const Vec middle = m.combine(k, basis(t)) - a / 6;
    at(0) = middle - v + a / 2;
    at(1) = middle;
    at(2) = middle + v + a / 2;
  };
  set_end(
      1, 0.0, 1, [&](std::size_t i) -> auto& { return out.c[i]; });
  set_end(
      m.size() - 3, 1.0, -1, [&](std::size_t i) -> auto& { return out.c[n - 1 - i]; });
  if (m.rest_begin) out.c[0] = out.c[1] = out.c[2] = m.c[0];
  if (m.rest_end) out.c[n - 1] = out.c[n - 2] = out.c[n - 3] = m.c.back();
  out.pass.reserve(m.pass.size());
  for (const double u : m.pass) {
    double low = 0, high = 1;  // the first guess is off by less than a step
    double x = std::clamp((u - 1) / (r * cells), 0.0, 1.0);
    for (int i = 0; i < 8; ++i) {
      (place(x) < u ? low : high) = x;
      const double slope = r * cells - spare * 30 * x * x * (1 - x) * (1 - x);
      x = std::clamp(x + (u - place(x)) / slope, low, high);
    }
    out.pass.push_back(1 + x * cells);
  }
  return out;
}

/// The same motion, exactly, on steps half as long.
template <int D>
MotionWindow<D> halved(const MotionWindow<D>& m) {
  MotionWindow<D> out;
  out.first = m.first;
  out.rest_begin = m.rest_begin;
  out.rest_end = m.rest_end;
  out.stride = m.stride / 2;
  out.c.resize(2 * m.size() - 3);
  for (std::size_t j = 0; j < out.size(); ++j) {
    const std::size_t k = (j + 1) / 2;
    out.c[j] = j % 2 == 1 ? typename MotionWindow<D>::Vec((m.c[k - 1] + 6 * m.c[k] + m.c[k + 1]) / 8)
                          : typename MotionWindow<D>::Vec((m.c[k] + m.c[k + 1]) / 2);
  }
  if (m.rest_begin) out.c[0] = out.c[1] = out.c[2] = m.c[0];
  if (m.rest_end) out.c[out.size() - 1] = out.c[out.size() - 2] = out.c[out.size() - 3] = m.c.back();
  out.pass.reserve(m.pass.size());
  for (const double u : m.pass) out.pass.push_back(2 * u - 1);
  return out;
}

}  // namespace toolpace::detail::tube
