#pragma once
/// When a motion passes which vertex of its path.

#include "toolpace/plan/smooth/motion_window.h"

namespace toolpace::detail::tube {

/// Moves each passing time to where the motion is nearest to its vertex. Where that would break the order, as at the tip of
/// a stroke that goes back on itself, neighbouring vertices share the time that is best for all of them (pooling of
/// adjacent violators).
template <int D>
class PassRefiner {
 public:
  using Vec = Eigen::Matrix<double, D, 1>;

  void apply(const TubePath& path, MotionWindow<D>& m) {
    pools_.clear();
    for (std::size_t i = 0; i < m.pass.size(); ++i) {
      const Vec p = vertex<D>(path, m.first + 1 + i);
      Pool pool{nearest(m, p, m.pass[i]), 1, p};
      while (!pools_.empty() && pools_.back().u > pool.u) {
        const Pool& before = pools_.back();
        const auto n = static_cast<double>(before.count), k = static_cast<double>(pool.count);
        const Vec middle = (n * before.middle + k * pool.middle) / (n + k);
        const double u = (n * before.u + k * pool.u) / (n + k);
        pool = {nearest(m, middle, u), before.count + pool.count, middle};
        pools_.pop_back();
      }
      pools_.push_back(pool);
    }
    std::size_t i = 0;
    for (const Pool& pool : pools_) {
      for (std::size_t q = 0; q < pool.count; ++q) m.pass[i++] = pool.u;
    }
  }

 private:
  struct Pool {
    double u;
    std::size_t count;
    Vec middle;  ///< mean of the vertices: nearest to it is best for the sum of their squared distances
  };

  /// Local search from `u`, at most three steps' way.
  static double nearest(const MotionWindow<D>& m, const Vec& p, double u) {
    const double top = static_cast<double>(m.size()) - 2;
    u = std::clamp(u, 1.0, top);
    for (int it = 0; it < 3; ++it) {
      double t;
      const std::size_t k = m.cell(u, t);
      const Vec e = m.combine(k, basis(t)) - p, v = m.combine(k, basis_slope(t)), a = m.combine(k, basis_bend(t));
      const double vv = v.squaredNorm(), full = vv + e.dot(a);
      const double slope = full > 0.3 * vv ? full : vv;
      if (!(slope > 0)) break;
      const double move = std::clamp(e.dot(v) / slope, -1.0, 1.0);
      u = std::clamp(u - move, 1.0, top);
      if (std::abs(move) < 1e-6) break;
    }
    return u;
  }

  std::vector<Pool> pools_;
};

}  // namespace toolpace::detail::tube
