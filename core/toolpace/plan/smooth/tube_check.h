#pragma once
/// Does a motion keep every limit and stay in its tube, in order? Shares no code with the optimiser's steps.

#include "toolpace/plan/smooth/motion_window.h"
#include "toolpace/plan/smooth/step_limits.h"

namespace toolpace::detail::tube {

/// How much of its limits a motion uses; all at most 1 for one that may be run.
struct Use {
  double limits = 0;              ///< largest use of a speed, acceleration or jerk limit, proven for all t
  double tube = 0;                ///< largest distance / tolerance at the stations and vertices
  std::vector<std::size_t> over;  ///< control points around which something is above 1, rising

  /// Positions of 1e4 mm carry 1e-12 mm of rounding, which differences of tiny steps feel.
  bool is_good() const { return limits <= 1 + 1e-6 && tube <= 1 + 1e-6; }
};

template <int D>
class TubeCheck {
 public:
  using Vec = Eigen::Matrix<double, D, 1>;
  TubeCheck(const TubePath& path, const StepLimits& limits) : path_(path), limits_(limits) {}

  Use measure(const MotionWindow<D>& m) const {
    Use use;
    check_differences(m, use);
    check_tube(m, use);
    return use;
  }

  /// Largest distance from the path at stations and vertices [mm, deg].
  double deviation(const MotionWindow<D>& m) const {
    double most = 0;
    walk(m, [&](std::size_t, double distance, double) { most = std::max(most, distance); });
    return most;
  }

 private:
  static void note(Use& use, std::size_t k) {
    if (use.over.empty() || use.over.back() < k) use.over.push_back(k);
  }

  double part(const Vec& z, int order, double norm) const {
    double square = 0;
    for (int a = 0; a < D; ++a) square += a < limits_.linear ? z[a] * z[a] : 0.0;
    double most = std::sqrt(square) / norm;
    for (int a = 0; a < D; ++a) most = std::max(most, std::abs(z[a]) / limits_.order[order][a]);
    return most;
  }

  void check_differences(const MotionWindow<D>& m, Use& use) const {
    const auto& c = m.c;
    const std::size_t n = c.size();
    std::size_t next = 0;  // first vertex that a speed's support may still reach
    for (std::size_t k = 0; k + 1 < n; ++k) {
      const Vec v = c[k + 1] - c[k];
      while (next < m.pass.size() && m.pass[next] < static_cast<double>(k) - 1) ++next;
      double feed = path_.feed[m.first + next];
      for (std::size_t i = next; i < m.pass.size() && m.pass[i] <= static_cast<double>(k) + 2; ++i) {
        feed = std::min(feed, path_.feed[m.first + i + 1]);
      }
      double most = part(v, 0, feed * limits_.step);
      if (k + 2 < n) most = std::max(most, part(c[k] - 2 * c[k + 1] + c[k + 2], 1, limits_.norm[1]));
      if (k + 3 < n) {
        most = std::max(most, part(c[k + 3] - c[k] - 3 * (c[k + 2] - c[k + 1]), 2, limits_.norm[2]));
      }
      use.limits = std::max(use.limits, most);
      if (!(most <= 1 + 1e-6)) note(use, k);
    }
  }

  void check_tube(const MotionWindow<D>& m, Use& use) const {
    std::vector<std::size_t> over;
    walk(m, [&](std::size_t k, double distance, double tolerance) {
      const double part = distance / tolerance;
      use.tube = std::max(use.tube, part);
      if (!(part <= 1 + 1e-6) && (over.empty() || over.back() != k)) over.push_back(k);
    });
    if (over.empty()) return;
    std::vector<std::size_t> all(use.over.size() + over.size());
    std::merge(use.over.begin(), use.over.end(), over.begin(), over.end(), all.begin());
    use.over.swap(all);
  }

  /// Couples the motion with the path: the vertices at their passing times, the stations in between with the furthest
  /// point reached so far on their segment, so that neither ever goes back (a Fréchet matching).
  template <class Visit>
  void walk(const MotionWindow<D>& m, Visit&& visit) const {
    std::size_t next = 0;
    double reached = 0;  // on the present segment, 0 … 1
    for (std::size_t k = 1; k + 2 < m.size(); ++k) {
      for (int i = 0; i < limits_.samples; ++i) {
        const double t = static_cast<double>(i) / limits_.samples;
        const double u = static_cast<double>(k) + t;
        for (; next < m.pass.size() && m.pass[next] <= u; ++next) {
          double tv;
          const std::size_t kv = m.cell(m.pass[next], tv);
          const std::size_t v = m.first + next + 1;
          const double tolerance = std::min(path_.tolerance[v - 1], path_.tolerance[v]);
          visit(k, (m.combine(kv, basis(tv)) - vertex<D>(path_, v)).norm(), tolerance);
          reached = 0;
        }
        const std::size_t s = m.first + next;
        const Vec p = vertex<D>(path_, s), d = vertex<D>(path_, s + 1) - p, x = m.combine(k, basis(t));
        if (k == 1 && i == 0 && !m.rest_begin) reached = 0;
        reached = std::max(reached, std::clamp((x - p).dot(d) / d.squaredNorm(), 0.0, 1.0));
        visit(k, (x - p - reached * d).norm(), path_.tolerance[s]);
      }
    }
  }

  const TubePath& path_;
  const StepLimits& limits_;
};

}  // namespace toolpace::detail::tube
