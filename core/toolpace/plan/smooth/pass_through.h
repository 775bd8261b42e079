#pragma once
/// Taking a needless stop out of a motion, roughly, before the optimiser gets it.

#include "toolpace/plan/smooth/tube_middle.h"
#include "toolpace/plan/smooth/warp.h"

namespace toolpace::detail::tube {

/// Runs the motion, wherever it is slower than a first motion would be, at that one's speed. A standstill cannot be
/// hurried by any factor; this one-off change of pace removes it. Limits may break; the ends stay as they are.
template <int D>
class PassThrough {
 public:
  using Vec = Eigen::Matrix<double, D, 1>;
  PassThrough(const TubePath& path, const TubeMiddle<D>& middle) : path_(path), middle_(middle) {}

  MotionWindow<D> apply(const MotionWindow<D>& m) const {
    std::vector<double> time = paces(m);  // of each interval, in steps
    soften(time);
    for (std::size_t k = 0; k < time.size(); ++k) time[k] = 1 - ease(m, k) * ease(m, k + 1) * (1 - time[k]);
    return run(m, time);
  }

 private:
  std::vector<double> paces(const MotionWindow<D>& m) const {
    std::vector<double> time(m.size() - 1, 1.0);
    std::size_t next = 0;
    double before = 0;
    for (std::size_t k = 1; k + 1 < m.size(); ++k) {
      const double u = static_cast<double>(k);
      while (next < m.pass.size() && m.pass[next] <= u) ++next;
      const std::size_t s = m.first + next;
      const Vec p = vertex<D>(path_, s), d = vertex<D>(path_, s + 1) - p;
      const Vec x = (m.c[k - 1] + 4 * m.c[k] + m.c[k + 1]) / 6;
      const double along = std::clamp((x - p).dot(d) / d.squaredNorm(), 0.0, 1.0);
      const double at = middle_.vertex_place(s) + along * d.norm();
      if (k > 1) {
        const double way = std::max(at - before, 0.0), there = (at + before) / 2;
        const double speed = middle_.speed_at(there, middle_.segment_at(there, s));
        time[k - 1] = speed > 0 ? std::min(1.0, way / speed) : 1.0;
      }
      before = std::max(before, at);
    }
    return time;
  }

  static void soften(std::vector<double>& time) {
    constexpr std::size_t kHalf = 4;
    std::vector<double> mean(time.size());
    for (int pass = 0; pass < 2; ++pass) {
      for (std::size_t k = 0; k < time.size(); ++k) {
        double sum = 0;
        for (std::size_t q = 0; q <= 2 * kHalf; ++q) {
          sum += time[std::min(time.size() - 1, k + q < kHalf ? 0 : k + q - kHalf)];
        }
        mean[k] = sum / (2 * kHalf + 1);
      }
      time.swap(mean);
    }
  }

  MotionWindow<D> run(const MotionWindow<D>& m, std::vector<double> time) const {
    double total = 0, room = 0;
    for (std::size_t k = 0; k < time.size(); ++k) {
      total += time[k];
      room += ease(m, k) * ease(m, k + 1);
    }
    const double add = room > 0 ? (std::ceil(total - 1e-9) - total) / room : 0;
    std::vector<double> at(m.size(), 0.0);
    for (std::size_t k = 0; k < time.size(); ++k) at[k + 1] = at[k] + time[k] + add * ease(m, k) * ease(m, k + 1);
    MotionWindow<D> r = m;
    const auto count = static_cast<std::size_t>(std::lround(at.back())) + 1;
    r.c.resize(count);
    std::size_t k = 0;
    for (std::size_t j = 0; j < count; ++j) {
      const double target = static_cast<double>(j);
      while (k + 2 < m.size() && at[k + 1] <= target) ++k;
      const double span = at[k + 1] - at[k];
      r.c[j] = interpolate(m, k, span > 0 ? std::clamp((target - at[k]) / span, 0.0, 1.0) : 0.0);
    }
    for (std::size_t j = 0; j < 3; ++j) {
      r.c[j] = m.c[j];
      r.c[count - 1 - j] = m.c[m.size() - 1 - j];
    }
    for (double& u : r.pass) {
      const std::size_t q = std::min(m.size() - 2, static_cast<std::size_t>(std::max(u, 0.0)));
      u = at[q] + (u - static_cast<double>(q)) * (at[q + 1] - at[q]);
    }
    return r;
  }

  /// Lagrange's cubic through the control points, which is what shifting a spline in time does to them.
  static Vec interpolate(const MotionWindow<D>& m, std::size_t k, double t) {
    const auto c = [&](std::size_t i) -> const Vec& { return m.c[std::min(m.size() - 1, i)]; };
    const Vec& before = m.c[k > 0 ? k - 1 : 0];
    return -t * (1 - t) * (2 - t) / 6 * before + (1 - t) * (1 + t) * (2 - t) / 2 * c(k) +
           t * (1 + t) * (2 - t) / 2 * c(k + 1) - t * (1 - t) * (1 + t) / 6 * c(k + 2);
  }

  const TubePath& path_;
  const TubeMiddle<D>& middle_;
};

}  // namespace toolpace::detail::tube
