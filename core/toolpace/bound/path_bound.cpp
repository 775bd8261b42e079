#include "toolpace/bound/path_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "toolpace/bound/bound_valley.h"
#include "toolpace/bound/envelope.h"
#include "toolpace/law/law_table.h"
#include "toolpace/plan/block/block_plan.h"
#include "toolpace/plan/increasing_root.h"

namespace toolpace {
namespace {

using detail::Envelope;

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

constexpr double kNone = std::numeric_limits<double>::infinity();

std::vector<Envelope> envelopes(const SpeedLimits& limits, RampLimits Dynamics::*side, double jerk) {
  std::vector<Envelope> all;
  for (const Dynamics& d : limits.dynamics) all.emplace_back((d.*side).acceleration, jerk);
  return all;
}

/// Whether the stretch that a block lies in begins, and ends, at a reversal: there a motion may rest with all its acceleration,
/// as if there were no limit of the jerk.
struct Turns {
  bool before = false, after = false;
};

std::vector<Turns> turns_of(const SpeedLimits& limits, const std::vector<double>& cap) {
  std::vector<Turns> turns(limits.size());
  const auto turns_at = [&](std::size_t node) {
    return std::binary_search(limits.reversals.begin(), limits.reversals.end(), node);
  };
  if (limits.reversals.empty()) return turns;
  const auto is_end = [&](std::size_t node) { return cap[node] == 0 || turns_at(node); };
  for (std::size_t first = 0; first < limits.size();) {
    std::size_t last = first + 1;
    while (last < limits.size() && !is_end(last)) ++last;
    const Turns ends{turns_at(first), turns_at(last)};
    for (; first < last; ++first) turns[first] = ends;
  }
  return turns;
}

/// The fastest way through a block along the envelope.
struct Passage {
  double rise = 0, cruise = 0, fall = 0;                 ///< lengths [mm]
  double rise_time = 0, cruise_time = 0, fall_time = 0;  ///< [s]

  double time() const { return rise_time + cruise_time + fall_time; }
};

Passage pass(double v0, double v1, double cap, double length, const Envelope& up, const Envelope& down) {
  const double low = std::max(v0, v1);
  const auto excess = [&](double peak) { return up.length(v0, peak) + down.length(v1, peak) - length; };
  const double at_cap = excess(cap);
  double peak = cap;
  if (at_cap > 0) {
    const double at_low = excess(low);
    peak = at_low < 0 ? detail::increasing_root(low, cap, at_low, at_cap, excess) : low;
  }
  Passage p{up.length(v0, peak), 0, down.length(v1, peak), up.time(v0, peak), 0, down.time(v1, peak)};
  p.cruise = std::max(0.0, length - p.rise - p.fall);
  p.cruise_time = p.cruise / peak;
  return p;
}

/// What the valleys that caps throw add to the time along the envelope.
class ValleyScan {
 public:
  explicit ValleyScan(const SpeedLimits& limits) : limits_(limits) {}

  /// Takes the next block, and the speed at its start if that is a cap of a node alone, else 0.
  /// @return time that the valley which has come to its end adds [s]
  double take(std::size_t block, const Passage& p, double cap) {
    double gain = 0;
    if (cap > 0 && fall_ > 0) open(cap);
    if (is_open_) {
      if (p.rise > 0) {
        valley_.after += p.rise;
        envelope_time_ += p.rise_time;
        include(block, &Dynamics::up, valley_.acceleration, valley_.jerk);
      }
      if (p.fall > 0 || p.cruise > 0 || !(p.rise > 0)) gain = close();
    }
    if (p.cruise > 0 || p.rise > 0) fall_ = fall_time_ = deceleration_ = jerk_ = 0;
    if (p.fall > 0) {
      fall_ += p.fall;
      fall_time_ += p.fall_time;
      include(block, &Dynamics::down, deceleration_, jerk_);
    }
    return gain;
  }

 private:
  void open(double cap) {
    valley_ = {cap, fall_, 0, deceleration_, 0, jerk_};
    envelope_time_ = fall_time_;
    is_open_ = true;
  }

  double close() {
    is_open_ = false;
    if (!(valley_.after > 0) || std::isinf(valley_.jerk)) return 0;
    return std::max(0.0, detail::valley_time(valley_) - envelope_time_);
  }

  void include(std::size_t block, RampLimits Dynamics::*side, double& acceleration, double& jerk) const {
    const Dynamics& d = limits_.dynamics_of(block);
    acceleration = std::max(acceleration, (d.*side).acceleration);
    jerk = std::max({jerk, d.up.jerk, d.down.jerk});
  }

  const SpeedLimits& limits_;
  double fall_ = 0, fall_time_ = 0;  ///< of the envelope up to here [mm, s]
  double deceleration_ = 0, jerk_ = 0;
  detail::Valley valley_{};
  double envelope_time_ = 0;
  bool is_open_ = false;
};

}  // namespace

double path_bound(const SpeedLimits& limits, LawKind law) {
  const std::size_t n = limits.size();
  if (n == 0) return 0.0;
  const Dynamics jerks = largest_jerks(limits, law);
  const std::vector<Envelope> rising = envelopes(limits, &Dynamics::up, jerks.up.jerk);
  const std::vector<Envelope> falling = envelopes(limits, &Dynamics::down, jerks.down.jerk);
  const std::vector<Envelope> turned = envelopes(limits, &Dynamics::up, kNone),
                              turning = envelopes(limits, &Dynamics::down, kNone);
  const std::vector<double> cap = detail::joined_caps(limits);
  const std::vector<Turns> turns = turns_of(limits, cap);
  const auto up = [&](std::size_t i) -> const Envelope& { return (turns[i].before ? turned : rising)[limits.ramp[i]]; };
  const auto down = [&](std::size_t i) -> const Envelope& {
    return (turns[i].after ? turning : falling)[limits.ramp[i]];
  };
  std::vector<double> v = cap;
  for (std::size_t i = 0; i < n; ++i) v[i + 1] = std::min(v[i + 1], up(i).after(v[i], limits.length[i]));
  for (std::size_t i = n; i-- > 0;) v[i] = std::min(v[i], down(i).after(v[i + 1], limits.length[i]));
  const bool has_jerk = law_row(law).bounds_jerk;
  ValleyScan valleys(limits);
  double sum = 0.0, carry = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const Passage p = pass(v[i], v[i + 1], limits.block_cap[i], limits.length[i], up(i), down(i));
    double t = p.time();
    // Between turns nothing says how much of its acceleration a valley has to give up.
    const bool throws_valley = i > 0 && v[i] == cap[i] && !turns[i].before && !turns[i].after;
    if (has_jerk) t += valleys.take(i, p, throws_valley ? v[i] : 0.0);
    const double next = sum + t;
    carry += (sum - next) + t;
    sum = next;
  }
  return (sum + carry) * (1 - 1e-11);
}

}  // namespace toolpace
