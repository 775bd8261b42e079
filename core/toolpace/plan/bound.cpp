#include "toolpace/plan/bound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "toolpace/law/law_table.h"
#include "toolpace/plan/block_plan.h"
#include "toolpace/plan/increasing_root.h"

namespace toolpace {
namespace {

/// The fastest gain of speed: a = √(2Jv) up to v = A²/2J, then a = A.
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

/// Largest jerk of all blocks; infinite where the law has none.
Dynamics largest_jerks(const SpeedLimits& limits, LawKind law) {
  Dynamics all = limits.dynamics[0];
  for (const Dynamics& d : limits.dynamics) {
    all.up.jerk = std::max(all.up.jerk, d.up.jerk);
    all.down.jerk = std::max(all.down.jerk, d.down.jerk);
  }
  if (!law_row(law).bounds_jerk) all.up.jerk = all.down.jerk = std::numeric_limits<double>::infinity();
  return all;
}

double block_time(double v0, double v1, double cap, double length, const Envelope& up, const Envelope& down) {
  const double low = std::max(v0, v1);
  const auto excess = [&](double peak) { return up.length(v0, peak) + down.length(v1, peak) - length; };
  const double at_cap = excess(cap);
  double peak = cap;
  if (at_cap > 0) {
    const double at_low = excess(low);
    peak = at_low < 0 ? detail::increasing_root(low, cap, at_low, at_cap, excess) : low;
  }
  const double cruise = std::max(0.0, length - up.length(v0, peak) - down.length(v1, peak));
  return up.time(v0, peak) + down.time(v1, peak) + cruise / peak;
}

}  // namespace

double lower_bound(const SpeedLimits& limits, LawKind law) {
  const std::size_t n = limits.size();
  if (n == 0) return 0.0;
  const Dynamics jerks = largest_jerks(limits, law);
  std::vector<Envelope> up, down;
  for (const Dynamics& d : limits.dynamics) {
    up.emplace_back(d.up.acceleration, jerks.up.jerk);
    down.emplace_back(d.down.acceleration, jerks.down.jerk);
  }
  std::vector<double> v = detail::joined_caps(limits);
  for (std::size_t i = 0; i < n; ++i) v[i + 1] = std::min(v[i + 1], up[limits.ramp[i]].after(v[i], limits.length[i]));
  for (std::size_t i = n; i-- > 0;) v[i] = std::min(v[i], down[limits.ramp[i]].after(v[i + 1], limits.length[i]));
  double sum = 0.0, carry = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double t =
        block_time(v[i], v[i + 1], limits.block_cap[i], limits.length[i], up[limits.ramp[i]], down[limits.ramp[i]]);
    const double next = sum + t;
    carry += (sum - next) + t;
    sum = next;
  }
  return (sum + carry) * (1 - 1e-12);
}

}  // namespace toolpace
