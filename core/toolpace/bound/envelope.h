#pragma once
/// How fast any motion from a known speed can be a length later.

#include <algorithm>
#include <cmath>

namespace toolpace::detail {

/// The fastest gain of speed: a = √(2Jv) up to v = A²/2J, then a = A. Whoever starts from rest with jerk ≤ J has gained a²/2J
/// of speed when the acceleration has come to a.
class Envelope {
 public:
  Envelope(double acceleration, double jerk)
      : acceleration_(acceleration),
        rate_(std::sqrt(jerk / 2)),
        knee_(acceleration * acceleration / (2 * jerk)),
        knee_root_(std::sqrt(knee_)) {}

  double knee() const { return knee_; }

  /// Speed after `length` from v. Below the knee √v grows at the rate √(J/2), so v^1.5 grows by 1.5·√(2J) a mm.
  double after(double v, double length) const {
    if (v < knee_) {
      const double root = std::sqrt(v);
      const double cube = root * root * root + 3 * rate_ * length;
      const double knee_cube = knee_ * knee_root_;
      if (cube <= knee_cube) return std::cbrt(cube * cube);
      length = (cube - knee_cube) / (3 * rate_);
      v = knee_;
    }
    return std::sqrt(v * v + 2 * acceleration_ * length);
  }

  double length(double v0, double v1) const {
    const double below = std::min(v1, knee_), above = std::max(v0, knee_);
    double sum = 0;
    if (v0 < below) sum += (below * std::sqrt(below) - v0 * std::sqrt(v0)) / (3 * rate_);
    if (v1 > above) sum += (v1 - above) * (v1 + above) / (2 * acceleration_);
    return sum;
  }

  double time(double v0, double v1) const {
    const double below = std::min(v1, knee_), above = std::max(v0, knee_);
    double sum = 0;
    if (v0 < below) sum += (std::sqrt(below) - std::sqrt(v0)) / rate_;
    if (v1 > above) sum += (v1 - above) / acceleration_;
    return sum;
  }

 private:
  double acceleration_, rate_, knee_, knee_root_;
};

}  // namespace toolpace::detail
