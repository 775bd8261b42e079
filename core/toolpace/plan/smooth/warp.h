#pragma once
/// Applying a step: bend the motion, run time faster or slower, and express it again on uniform knots.

#include "toolpace/plan/smooth/motion_window.h"

namespace toolpace::detail::tube {

/// 0 … 1: how freely the pace may change at control point k. It fades out towards an end that is in motion, where the
/// neighbour's motion goes on unchanged.
template <int D>
double ease(const MotionWindow<D>& m, std::size_t k) {
  const auto fade = [&](double steps) {
    const double x = std::clamp((steps - 4) * static_cast<double>(m.stride) / 24, 0.0, 1.0);
    return x * x * (3 - 2 * x);
  };
  const double begin = m.rest_begin ? 1 : fade(static_cast<double>(k));
  const double end = m.rest_end ? 1 : fade(static_cast<double>(m.size() - 1 - k));
  return begin * end;
}

/// Control point of the uniform spline of X(t) = x(u(t)) from its value and second derivative (quasi-interpolation,
/// c = X − X″/6, exact for splines on the same knots).
template <int D>
class Warp {
 public:
  using Vec = Eigen::Matrix<double, D, 1>;

  void apply(MotionWindow<D>& m, const std::vector<Vec>& bend, const std::vector<double>& pace) {
    const std::size_t n = m.size();
    for (std::size_t k = 0; k < n; ++k) m.c[k] += bend[k];
    slow_.resize(n);
    bool any = false;
    for (std::size_t k = 0; k < n; ++k) {
      slow_[k] = std::exp(-pace[k]);
      any |= pace[k] != 0;
    }
    was_.clear();
    if (!any) return;
    const std::size_t count = fit(m);
    resample(m, count);
    for (double& u : m.pass) u = time_of(u);
  }

  /// The old control point nearest to each new one; none if the pace has not changed.
  const std::vector<std::size_t>& was() const { return was_; }

 private:
  /// Scales the slowness up so that the duration is a whole number of steps.
  std::size_t fit(const MotionWindow<D>& m) {
    const std::size_t n = slow_.size();
    double total = 0, room = 0;
    const auto soft = [&](std::size_t k) { return ease(m, k); };
    for (std::size_t k = 0; k < n; ++k) {
      const double w = k == 0 || k + 1 == n ? 0.5 : 1;
      total += w * slow_[k];
      room += w * slow_[k] * soft(k);
    }
    // Down only by a share that no limit feels: what is rounded off here comes back as a broken limit.
    const double whole = std::ceil(total - 0.02);
    const double k0 = room > 0 ? (whole - total) / room : 0;
    for (std::size_t k = 0; k < n; ++k) slow_[k] *= 1 + k0 * soft(k);
    time_.resize(n);
    time_[0] = 0;
    for (std::size_t k = 0; k + 1 < n; ++k) time_[k + 1] = time_[k] + (slow_[k] + slow_[k + 1]) / 2;
    return static_cast<std::size_t>(whole) + 1;
  }

  double time_of(double u) const {
    const std::size_t k = std::min(slow_.size() - 2, static_cast<std::size_t>(std::max(u, 0.0)));
    const double t = u - static_cast<double>(k);
    return time_[k] + t * (slow_[k] + (slow_[k + 1] - slow_[k]) * t / 2);
  }

  void resample(MotionWindow<D>& m, std::size_t count) {
    const std::size_t n = m.size();
    const auto at = [&](std::ptrdiff_t i) -> const Vec& {
      return m.c[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, static_cast<std::ptrdiff_t>(n) - 1))];
    };
    const auto bend_of_time = [&](std::size_t k) {  // dq/du of the slowness q, central
      if (k == 0 || k + 1 >= n) return 0.0;
      return (slow_[k + 1] - slow_[k - 1]) / 2;
    };
    out_.resize(count);
    std::size_t k = 0;
    for (std::size_t j = 0; j < count; ++j) {
      const double target = static_cast<double>(j);
      while (k + 2 < n && time_[k + 1] <= target) ++k;
      was_.push_back(target - time_[k] > time_[k + 1] - target ? k + 1 : k);
      const double q0 = slow_[k], dq = slow_[k + 1] - q0, rest = target - time_[k];
      const double root = std::sqrt(std::max(q0 * q0 + 2 * dq * rest, 0.0));
      const double t = std::clamp(2 * rest / (q0 + root), 0.0, 1.0);
      const double q = q0 + dq * t;
      const double slope = bend_of_time(k) * (1 - t) + bend_of_time(k + 1) * t;
      const double rate = 1 / q, gain = -slope * rate * rate * rate;  // u̇, ü
      const auto i = static_cast<std::ptrdiff_t>(k);
      const Vec &a = at(i - 1), &b = at(i), &c = at(i + 1), &d = at(i + 2);
      const Basis p = basis(t), v = basis_slope(t), w = basis_bend(t);
      const double bend = -rate * rate / 6, tilt = -gain / 6;
      out_[j] = (p.w[0] + tilt * v.w[0] + bend * w.w[0]) * a + (p.w[1] + tilt * v.w[1] + bend * w.w[1]) * b +
                (p.w[2] + tilt * v.w[2] + bend * w.w[2]) * c + (p.w[3] + tilt * v.w[3] + bend * w.w[3]) * d;
    }
    if (m.rest_begin) {
      for (std::size_t j = 0; j < 3; ++j) out_[j] = m.c[0];
    } else {
      for (std::size_t j = 0; j < 3; ++j) out_[j] = m.c[j];
    }
    for (std::size_t j = 0; j < 3; ++j) out_[count - 1 - j] = m.rest_end ? m.c[n - 1] : m.c[n - 1 - j];
    m.c.swap(out_);
  }

  std::vector<double> slow_, time_;
  std::vector<std::size_t> was_;
  std::vector<Vec> out_;
};

}  // namespace toolpace::detail::tube
