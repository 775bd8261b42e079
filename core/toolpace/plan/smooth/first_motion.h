#pragma once
/// A first, unambitious motion along a stretch of the path, from rest to rest, for the optimiser to improve.

#include "toolpace/plan/smooth/motion_window.h"
#include "toolpace/plan/smooth/step_limits.h"

namespace toolpace::detail::tube {

/// The polyline averaged over ±width, exactly, by its integral.
template <int D>
class SmoothedPolyline {
 public:
  using Vec = Eigen::Matrix<double, D, 1>;
  SmoothedPolyline(const TubePath& path, std::size_t begin, std::size_t end) {
    const std::size_t n = end - begin;
    s.resize(n + 1);
    p_.resize(n + 1);
    area_.resize(n + 1);
    s[0] = 0;
    p_[0] = vertex<D>(path, begin);
    area_[0].setZero();
    for (std::size_t i = 0; i < n; ++i) {
      p_[i + 1] = vertex<D>(path, begin + i + 1);
      s[i + 1] = s[i] + (p_[i + 1] - p_[i]).norm();
      area_[i + 1] = area_[i] + (s[i + 1] - s[i]) / 2 * (p_[i] + p_[i + 1]);
    }
  }
  std::size_t locate(double x) const {
    const auto it = std::upper_bound(s.begin(), s.end(), x);
    const auto i = static_cast<std::size_t>(it - s.begin());
    return std::clamp<std::size_t>(i, 1, s.size() - 1) - 1;
  }
  Vec at(double x) const {
    const std::size_t i = locate(x);
    return p_[i] + (p_[i + 1] - p_[i]) * ((x - s[i]) / (s[i + 1] - s[i]));
  }
  Vec direction(double x) const {
    const std::size_t i = locate(x);
    return (p_[i + 1] - p_[i]) / (s[i + 1] - s[i]);
  }
  Vec smooth(double x, double width) const {
    if (width <= 1e-9) return at(x);
    return (area(x + width) - area(x - width)) / (2 * width);
  }
  const Vec& vertex_at(std::size_t i) const { return p_[i]; }
  std::vector<double> s;

 private:
  Vec area(double x) const {
    const std::size_t i = locate(x);
    const double d = x - s[i];
    return area_[i] + d * (p_[i] + (p_[i + 1] - p_[i]) * (d / (2 * (s[i + 1] - s[i]))));
  }
  std::vector<Vec> p_, area_;
};

template <int D>
class FirstMotion {
 public:
  using Vec = Eigen::Matrix<double, D, 1>;
  FirstMotion(const TubePath& path, const StepLimits& limits, std::size_t begin, std::size_t end)
      : path_(path), limits_(limits), begin_(begin), line_(path, begin, end) {}

  MotionWindow<D> make() {
    choose_widths();
    choose_speeds(0.0);
    return march();
  }

  /// Only the speeds that such a motion has [mm a step], for a stretch that begins and ends in motion.
  void prepare_speeds() {
    choose_widths();
    choose_speeds(TubeLimits::kNone);
  }
  double speed_at(double s) const {
    const std::size_t i = line_.locate(s);
    const double before = speed_[i] * speed_[i] + 2 * gain_[i] * (s - line_.s[i]);
    const double after = speed_[i + 1] * speed_[i + 1] + 2 * gain_[i] * (line_.s[i + 1] - s);
    return std::min(std::sqrt(std::max(std::min(before, after), 0.0)), feed(i));
  }
  const SmoothedPolyline<D>& line() const { return line_; }

 private:
  double axis_room(const Vec& u, int order) const {
    double most = limits_.norm[order];
    for (int a = 0; a < D; ++a) {
      const double x = std::abs(u[a]);
      if (x > 0) most = std::min(most, limits_.order[order][a] / x);
    }
    return most;
  }

  void choose_widths() {
    const std::size_t n = line_.s.size();
    const double length = line_.s.back();
    width_.assign(n, 0);
    for (std::size_t i = 1; i + 1 < n; ++i) {
      const double tol = 0.4 * std::min(path_.tolerance[begin_ + i - 1], path_.tolerance[begin_ + i]);
      const double most = std::min(line_.s[i], length - line_.s[i]);
      double w = tol;
      while (w < most && (line_.smooth(line_.s[i], w) - line_.vertex_at(i)).norm() < tol) w *= 1.3;
      width_[i] = std::min(w / 1.3, most);
    }
    for (std::size_t i = 1; i < n; ++i)
      width_[i] = std::min(width_[i], width_[i - 1] + 0.4 * (line_.s[i] - line_.s[i - 1]));
    for (std::size_t i = n - 1; i-- > 0;)
      width_[i] = std::min(width_[i], width_[i + 1] + 0.4 * (line_.s[i + 1] - line_.s[i]));
  }
  double width(double x) const {
    const std::size_t i = line_.locate(x);
    return std::min(width_[i] + 0.4 * (x - line_.s[i]), width_[i + 1] + 0.4 * (line_.s[i + 1] - x));
  }

  void choose_speeds(double at_ends) {
    const std::size_t n = line_.s.size();
    speed_.assign(n, 0);
    speed_.front() = std::min(at_ends, feed(0));
    speed_.back() = std::min(at_ends, feed(n - 2));
    for (std::size_t i = 1; i + 1 < n; ++i) {
      const double x = line_.s[i], w = std::max(width_[i], 1e-9);
      double v = 1e300;
      for (double shift : {-0.5, 0.0, 0.5}) {
        const Vec bend = (line_.direction(std::min(x + (shift + 1) * w, line_.s.back())) -
                          line_.direction(std::max(x + (shift - 1) * w, 0.0))) /
                         (2 * w);
        v = std::min(v, std::sqrt(0.5 * axis_room(bend, 1)));
        v = std::min(v, std::cbrt(0.25 * w * axis_room(bend, 2)));
      }
      speed_[i] = std::min({v, feed(i - 1), feed(i)});
    }
    gain_.resize(n - 1);
    for (std::size_t i = 0; i + 1 < n; ++i) {
      const Vec u = line_.direction((line_.s[i] + line_.s[i + 1]) / 2);
      double a = 0.3 * axis_room(u, 1);
      const double j = axis_room(u, 2);
      const double f = feed(i);
      a = std::min(a, std::sqrt(0.3 * j * f));  // reaching the feed takes at least √(v/j)
      a = std::min(a, 0.5 * std::cbrt(j * j * line_.s.back()));
      gain_[i] = a;
    }
    for (std::size_t i = 1; i < n; ++i) {
      speed_[i] = std::min(speed_[i],
                           std::sqrt(speed_[i - 1] * speed_[i - 1] + 2 * gain_[i - 1] * (line_.s[i] - line_.s[i - 1])));
    }
    for (std::size_t i = n - 1; i-- > 0;) {
      speed_[i] =
          std::min(speed_[i], std::sqrt(speed_[i + 1] * speed_[i + 1] + 2 * gain_[i] * (line_.s[i + 1] - line_.s[i])));
    }
  }
  /// Top speed along a segment; the programmed feed counts the linear axes alone.
  double feed(std::size_t i) const {
    const Vec u = line_.direction((line_.s[i] + line_.s[i + 1]) / 2);
    double square = 0;
    for (int a = 0; a < D; ++a) square += a < limits_.linear ? u[a] * u[a] : 0.0;
    const double top = path_.feed[begin_ + i] * limits_.step / std::max(std::sqrt(square), 1e-9);
    return 0.95 * std::min(axis_room(u, 0), top);
  }

  MotionWindow<D> march() {
    std::vector<double> x = {0, 0, 0};
    const double length = line_.s.back();
    double s = 0;
    std::size_t i = 0;
    double spread = 0;
    while (s < length) {
      while (i + 2 < line_.s.size() && line_.s[i + 1] <= s) ++i;
      const double a = gain_[i];
      const double v = std::max(speed_at(s), 0.5 * a);
      s = std::min(s + v, length);
      x.push_back(s);
      const Vec u = line_.direction(s);
      spread = std::max(spread, std::min(a / axis_room(u, 2), 200.0));
    }
    const auto half = static_cast<std::size_t>(std::ceil(0.35 * spread));
    const std::size_t pad = half + 2;
    x.insert(x.begin(), pad, 0.0);
    x.insert(x.end(), pad + 3, length);
    MotionWindow<D> m;
    m.first = begin_;
    double sum = 0;
    const std::size_t n = x.size();
    std::vector<double> y(n);
    for (std::size_t k = 0; k < n; ++k) {
      if (k == 0) {
        for (std::size_t q = 0; q <= half; ++q) sum += x[q];
        sum += static_cast<double>(half) * x[0];
      }
      y[k] = std::clamp(sum / static_cast<double>(2 * half + 1), 0.0, length);
      sum += x[std::min(n - 1, k + half + 1)] - x[k >= half ? k - half : 0];
    }
    y[n - 1] = y[n - 2] = y[n - 3] = length;
    y[0] = y[1] = y[2] = 0;
    for (std::size_t k = 0; k < n; ++k) {
      m.c.push_back(y[k] >= length ? line_.vertex_at(line_.s.size() - 1)
                                   : line_.smooth(y[k], std::min({width(y[k]), y[k], length - y[k]})));
    }
    std::size_t k = 0;
    for (std::size_t v = 1; v + 1 < line_.s.size(); ++v) {
      while (k + 2 < n && y[k + 1] < line_.s[v]) ++k;
      const double d = y[k + 1] - y[k];
      m.pass.push_back(static_cast<double>(k) + (d > 0 ? std::clamp((line_.s[v] - y[k]) / d, 0.0, 1.0) : 0.0));
    }
    return m;
  }

  const TubePath& path_;
  const StepLimits& limits_;
  std::size_t begin_;
  SmoothedPolyline<D> line_;
  std::vector<double> width_, speed_, gain_;
};

}  // namespace toolpace::detail::tube
