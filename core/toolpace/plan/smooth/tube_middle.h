#pragma once
/// The middle of a tube: its polyline with corners rounded inside the tolerance, and how fast that may be run for certain.

#include "toolpace/plan/smooth/motion_window.h"
#include "toolpace/plan/smooth/step_limits.h"

namespace toolpace::detail::tube {

/// All places are path lengths from the tube's beginning. What asks for a segment takes the one that holds the place.
template <int D>
class TubeMiddle {
 public:
  using Vec = Eigen::Matrix<double, D, 1>;

  TubeMiddle(const TubePath& path, const StepLimits& limits) : path_(path), limits_(limits) {
    measure();
    choose_widths();
    choose_speeds();
  }

  std::size_t segments() const { return s_.size() - 1; }
  double vertex_place(std::size_t i) const { return s_[i]; }
  double length() const { return s_.back(); }
  std::size_t segment_at(double s) const {
    const auto i = static_cast<std::size_t>(std::upper_bound(s_.begin(), s_.end(), s) - s_.begin());
    return std::clamp<std::size_t>(i, 1, segments()) - 1;
  }
  /// The same, looked for from a segment nearby.
  std::size_t segment_at(double s, std::size_t near) const {
    while (near + 2 < s_.size() && s_[near + 1] <= s) ++near;
    while (near > 0 && s_[near] > s) --near;
    return near;
  }

  Vec direction(std::size_t i) const { return (p_[i + 1] - p_[i]) / (s_[i + 1] - s_[i]); }
  /// Point of the middle.
  /// @param most  of the width that is averaged over, to either side
  Vec point(double s, std::size_t i, double most = 1e300) const {
    const double width = std::min(
        {width_[i] + kWidthSlope * (s - s_[i]), width_[i + 1] + kWidthSlope * (s_[i + 1] - s), s, s_.back() - s, most});
    return average(s, std::max(width, 0.0), i);
  }

  /// Speed that can be held on a segment's direction [mm a step].
  double top(std::size_t i) const { return top_[i]; }
  double vertex_speed(std::size_t i) const { return speed_[i]; }
  /// Acceleration of the ramps between them [mm a step²].
  double gain(std::size_t i) const { return gain_[i]; }
  double speed_at(double s, std::size_t i) const {
    const double before = speed_[i] * speed_[i] + 2 * gain_[i] * (s - s_[i]);
    const double after = speed_[i + 1] * speed_[i + 1] + 2 * gain_[i] * (s_[i + 1] - s);
    return std::min(std::sqrt(std::max(std::min(before, after), 0.0)), top_[i]);
  }
  /// Steps from the beginning to a vertex at these speeds.
  double vertex_time(std::size_t i) const { return time_[i]; }

  /// Limit of a motion along a direction.
  double room(const Vec& u, int order) const {
    double most = limits_.norm[order];
    for (int a = 0; a < D; ++a) {
      const double x = std::abs(u[a]);
      if (x > 0) most = std::min(most, limits_.order[order][a] / x);
    }
    return most;
  }

 private:
  static constexpr double kWidthSlope = 0.1;
  static constexpr double kToleranceShare = 0.85;
  static constexpr int kBisections = 7;
  static constexpr double kTopShare = 0.9999;

  void measure() {
    const std::size_t n = path_.segments();
    s_.resize(n + 1);
    p_.resize(n + 1);
    area_.resize(n + 1);
    s_[0] = 0;
    p_[0] = vertex<D>(path_, 0);
    area_[0].setZero();
    for (std::size_t i = 0; i < n; ++i) {
      p_[i + 1] = vertex<D>(path_, i + 1);
      s_[i + 1] = s_[i] + (p_[i + 1] - p_[i]).norm();
      area_[i + 1] = area_[i] + (s_[i + 1] - s_[i]) / 2 * (p_[i] + p_[i + 1]);
    }
  }

  Vec area(double s, std::size_t near) const {
    const std::size_t i = segment_at(s, near);
    const double d = s - s_[i];
    return area_[i] + d * (p_[i] + (p_[i + 1] - p_[i]) * (d / (2 * (s_[i + 1] - s_[i]))));
  }
  /// The polyline averaged over ±width, exactly, by its integral.
  Vec average(double s, double width, std::size_t i) const {
    if (width <= 1e-9) return p_[i] + (p_[i + 1] - p_[i]) * ((s - s_[i]) / (s_[i + 1] - s_[i]));
    return (area(s + width, i) - area(s - width, i)) / (2 * width);
  }

  void choose_widths() {
    const std::size_t n = s_.size();
    width_.assign(n, 0);
    for (std::size_t i = 1; i + 1 < n; ++i) {
      const double tol = kToleranceShare * std::min(path_.tolerance[i - 1], path_.tolerance[i]);
      const double most = std::min(s_[i], s_.back() - s_[i]);
      const auto fits = [&](double w) { return w < most && (average(s_[i], w, i) - p_[i]).norm() < tol; };
      double low = 0, high = tol;
      while (fits(high)) {
        low = high;
        high *= 1.5;
      }
      for (int k = 0; k < kBisections; ++k) {
        const double middle = (low + high) / 2;
        (fits(middle) ? low : high) = middle;
      }
      width_[i] = std::min(low, most);
    }
    for (std::size_t i = 1; i < n; ++i)
      width_[i] = std::min(width_[i], width_[i - 1] + kWidthSlope * (s_[i] - s_[i - 1]));
    for (std::size_t i = n - 1; i-- > 0;) {
      width_[i] = std::min(width_[i], width_[i + 1] + kWidthSlope * (s_[i + 1] - s_[i]));
    }
  }

  /// The programmed feed counts the linear axes alone.
  double top_on(std::size_t i) const {
    const Vec u = direction(i);
    double square = 0;
    for (int a = 0; a < D; ++a) square += a < limits_.linear ? u[a] * u[a] : 0.0;
    const double feed = path_.feed[i] * limits_.step / std::max(std::sqrt(square), 1e-9);
    return kTopShare * std::min(room(u, 0), feed);
  }

  /// Speed at which the bend about a vertex can be run.
  double bend_speed(std::size_t i) const {
    const double w = std::max(width_[i], 1e-9);
    double v = 1e300;
    for (const double shift : {-0.5, 0.0, 0.5}) {
      const double after = std::min(s_[i] + (shift + 1) * w, s_.back()),
                   before = std::max(s_[i] + (shift - 1) * w, 0.0);
      const Vec bend = (direction(segment_at(after, i)) - direction(segment_at(before, i))) / (2 * w);
      v = std::min(v, std::sqrt(0.7 * room(bend, 1)));
      v = std::min(v, std::cbrt(w * room(bend, 2)));
    }
    return v;
  }

  void choose_speeds() {
    const std::size_t n = s_.size();
    top_.resize(n - 1);
    gain_.resize(n - 1);
    for (std::size_t i = 0; i + 1 < n; ++i) {
      const Vec u = direction(i);
      top_[i] = top_on(i);
      const double j = room(u, 2);
      // Up to the top takes at least √(v/j), and the whole way at least ∛(s/j).
      gain_[i] = std::min({0.3 * room(u, 1), std::sqrt(0.3 * j * top_[i]), 0.5 * std::cbrt(j * j * length())});
    }
    speed_.assign(n, 0);
    for (std::size_t i = 1; i + 1 < n; ++i) speed_[i] = std::min({bend_speed(i), top_[i - 1], top_[i]});
    const auto reached = [&](double from, std::size_t i) {
      return std::sqrt(from * from + 2 * gain_[i] * (s_[i + 1] - s_[i]));
    };
    for (std::size_t i = 1; i < n; ++i) speed_[i] = std::min(speed_[i], reached(speed_[i - 1], i - 1));
    for (std::size_t i = n - 1; i-- > 0;) speed_[i] = std::min(speed_[i], reached(speed_[i + 1], i));
    time_.assign(n, 0);
    for (std::size_t i = 0; i + 1 < n; ++i) {
      const double l = s_[i + 1] - s_[i], middle = speed_at(s_[i] + l / 2, i);
      const double mean = (speed_[i] + 4 * middle + speed_[i + 1]) / 6;
      time_[i + 1] = time_[i] + (mean > 0 ? l / mean : 0.0);
    }
  }

  const TubePath& path_;
  const StepLimits& limits_;
  std::vector<double> s_, width_, speed_, top_, gain_, time_;
  std::vector<Vec> p_, area_;
};

}  // namespace toolpace::detail::tube
