#pragma once
/// The plan of last resort: along every segment from rest to rest, exactly on the path.

#include "toolpace/plan/smooth/motion_window.h"
#include "toolpace/plan/smooth/step_limits.h"

namespace toolpace::detail::tube {

/// Widths of three boxes whose convolution is the speed of one segment's move: its differences then keep the limits.
/// With n1 ≥ n2 ≥ n3 the peaks are d/n1, d/(n1·n2) and at most 2d/(n1·n2·n3).
struct Boxes {
  std::size_t n[3];
};
template <int D>
Boxes boxes_for(const Eigen::Matrix<double, D, 1>& d, double feed, const StepLimits& limits) {
  double square = 0;
  for (int a = 0; a < D; ++a) square += a < limits.linear ? d[a] * d[a] : 0.0;
  const double length = std::sqrt(square);
  double need[3] = {std::max(length / (feed * limits.step), 1.0), length / limits.norm[1], 2 * length / limits.norm[2]};
  for (int order = 0; order < 3; ++order) {
    for (int a = 0; a < D; ++a) {
      need[order] = std::max(need[order], (order == 2 ? 2 : 1) * std::abs(d[a]) / limits.order[order][a]);
    }
  }
  const auto up = [](double x) { return static_cast<std::size_t>(std::max(1.0, std::ceil(x * (1 + 1e-9)))); };
  const std::size_t n1 = up(std::max({need[0], std::sqrt(need[1]), std::cbrt(need[2])}));
  const auto first = static_cast<double>(n1);
  const std::size_t n2 = std::min(n1, up(std::max(need[1] / first, std::sqrt(need[2] / first))));
  const std::size_t n3 = std::min(n2, up(need[2] / (first * static_cast<double>(n2))));
  return {{n1, n2, n3}};
}

/// Shares of the way after each step of a move with these boxes: from 0 to 1, monotone.
inline std::vector<double> box_way(const Boxes& boxes) {
  std::vector<double> speed = {1.0};
  for (const std::size_t n : boxes.n) {
    std::vector<double> wide(speed.size() + n - 1, 0.0);
    for (std::size_t i = 0; i < wide.size(); ++i) {
      // Direct sums, not running ones: equal boxes then cancel to the bit.
      double sum = 0;
      const std::size_t low = i + 1 > n ? i + 1 - n : 0;
      for (std::size_t q = low; q <= std::min(i, speed.size() - 1); ++q) sum += speed[q];
      wide[i] = sum / static_cast<double>(n);
    }
    speed.swap(wide);
  }
  std::vector<double> way;
  double sum = 0;
  for (const double v : speed) way.push_back(std::min(1.0, sum += v));
  way.back() = 1.0;
  return way;
}

template <int D>
MotionWindow<D> exact_motion(const TubePath& path, const StepLimits& limits, std::size_t begin, std::size_t end) {
  MotionWindow<D> m;
  m.first = begin;
  m.c.assign(3, vertex<D>(path, begin));
  for (std::size_t s = begin; s < end; ++s) {
    const auto p = vertex<D>(path, s);
    const Eigen::Matrix<double, D, 1> d = vertex<D>(path, s + 1) - p;
    for (const double w : box_way(boxes_for<D>(d, path.feed[s] * 0.999, limits))) m.c.push_back(p + w * d);
    m.c.back() = vertex<D>(path, s + 1);
    m.c.push_back(m.c.back());
    m.c.push_back(m.c.back());
    if (s + 1 < end) m.pass.push_back(static_cast<double>(m.c.size()) - 2);
  }
  return m;
}

}  // namespace toolpace::detail::tube
