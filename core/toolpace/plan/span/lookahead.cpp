#include "toolpace/plan/span/lookahead.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "toolpace/law/law_table.h"
#include "toolpace/plan/increasing_root.h"
#include "toolpace/plan/plan.h"

namespace toolpace::detail {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
/// A stop that is longer than its window by this share is rounding.
constexpr double kExcessMargin = 1e-9;
/// Share by which speeds are lowered further than they need, so that the search ends.
constexpr double kMargin = 1e-4;
/// [mm] A rest may be missed by this share of a micrometre.
constexpr double kLeastWay = 1e-3;

void include(Dynamics& all, const Dynamics& d) {
  for (RampLimits Dynamics::*side : {&Dynamics::up, &Dynamics::down}) {
    RampLimits& a = all.*side;
    const RampLimits& b = d.*side;
    a.acceleration = std::min(a.acceleration, b.acceleration);
    a.jerk = std::min(a.jerk, b.jerk);
    a.time = std::max(a.time, b.time);
  }
}

Dynamics smallest_of_all(const SpeedLimits& limits) {
  Dynamics all = limits.dynamics[limits.ramp[0]];
  for (std::size_t i = 1; i < limits.size(); ++i) {
    if (limits.ramp[i] != limits.ramp[i - 1]) include(all, limits.dynamics_of(i));
  }
  return all;
}

/// Smallest limits of the blocks i … i + count − 1, for each i: two scans over stretches of `count` blocks.
std::vector<Dynamics> smallest_in_windows(const SpeedLimits& limits, std::size_t count) {
  const std::size_t n = limits.size();
  std::vector<Dynamics> prefix(n), suffix(n);
  for (std::size_t i = 0; i < n; ++i) {
    prefix[i] = limits.dynamics_of(i);
    if (i % count != 0) include(prefix[i], prefix[i - 1]);
  }
  for (std::size_t i = n; i-- > 0;) {
    suffix[i] = limits.dynamics_of(i);
    if ((i + 1) % count != 0 && i + 1 < n) include(suffix[i], suffix[i + 1]);
  }
  for (std::size_t i = 0; i < n; ++i) include(suffix[i], prefix[std::min(n - 1, i + count - 1)]);
  return suffix;
}

}  // namespace

StopWindow::StopWindow(const SpeedLimits& limits, LawKind law, std::size_t blocks) : limits_(limits), law_(law) {
  const std::size_t n = limits.size();
  const NodePositions position = node_positions(limits);
  way_.assign(n + 1, kUnbounded);
  double shortest = kUnbounded;
  for (std::size_t i = 1; i + blocks - 1 < n; ++i) {
    way_[i] = position.between(i, i + blocks - 1);
    shortest = std::min(shortest, way_[i]);
  }
  const Dynamics all = smallest_of_all(limits);
  const double top = *std::max_element(limits.block_cap.begin(), limits.block_cap.end());
  double steepest = 0;
  for (const Dynamics& d : limits.dynamics) steepest = std::max(steepest, d.up.acceleration);
  never_binds_ = stop_length(top, steepest, all) <= shortest;
  if (never_binds_ || blocks == 1) {
    dynamics_ = {all};
  } else {
    dynamics_ = limits.dynamics.size() == 1 ? limits.dynamics : smallest_in_windows(limits, blocks - 1);
    if (dynamics_.size() > 1) dynamics_.push_back(dynamics_.back());
  }
}

double StopWindow::stop_length(double speed, double acceleration, const Dynamics& d) const {
  const LawRow& law = law_row(law_);
  double way = 0;
  if (acceleration > 0 && law.bounds_jerk && std::isfinite(acceleration)) {
    const double time = acceleration / d.up.jerk;
    way = time * (speed + time * acceleration / 3);
    speed += time * acceleration / 2;
  }
  return way + speed / 2 * law.duration(speed, d.down);
}

void StopWindow::lower(std::vector<double>& cap) const {
  if (never_binds_) return;
  const LawRow& law = law_row(law_);
  for (std::size_t i = 1; i + 1 < cap.size(); ++i) {
    if (way_[i] == kUnbounded || stop_length(cap[i], 0, dynamics_of(i)) <= way_[i]) continue;
    cap[i] = way_[i] > 0 ? std::min(cap[i], law.reach(0, way_[i], dynamics_of(i).down)) : 0.0;
  }
}

void StopWindow::lower(std::vector<Turn>& turns, const std::vector<double>& cap) const {
  if (never_binds_) return;
  for (Turn& turn : turns) {
    const double way = way_[turn.node];
    const Dynamics& d = dynamics_of(turn.node);
    const auto excess = [&](double a) { return stop_length(0, a, d) - way; };
    const double at_most = excess(turn.acceleration);
    if (!(at_most > 0)) continue;
    const double most = way > 0 ? increasing_root(0.0, turn.acceleration, -way, at_most, excess) * (1 - kMargin) : 0.0;
    turn.acceleration = is_worth_turning(most, d.up.jerk, cap[turn.node]) ? most : 0.0;
  }
}

/// Calls f(node, state, excess length) until it returns false.
template <class F>
void StopWindow::for_each_too_fast(const MotionPlan& plan, F&& f) const {
  if (never_binds_) return;
  const std::vector<double> time = node_times(limits_, plan);
  std::size_t k = 0;
  for (std::size_t i = 1; i + 1 < time.size(); ++i) {
    while (k + 1 < plan.phases.size() && plan.phases[k + 1].begin <= time[i]) ++k;
    if (way_[i] == kUnbounded) continue;
    const PhaseState there = evaluate(plan.phases[k], time[i] - plan.phases[k].begin);
    const double excess = stop_length(there.speed, there.acceleration, dynamics_of(i)) - way_[i];
    if (excess > (way_[i] + kLeastWay) * kExcessMargin && !f(i, there, excess)) return;
  }
}

bool StopWindow::holds(const MotionPlan& plan) const {
  bool all = true;
  for_each_too_fast(plan, [&](std::size_t, const PhaseState&, double) { return all = false; });
  return all;
}

double StopWindow::slower(const PhaseState& there, std::size_t node, double excess) const {
  const Dynamics& d = dynamics_of(node);
  const double step = 1e-4 * there.speed;
  const double slope = (stop_length(there.speed + step, there.acceleration, d) - way_[node] - excess) / step;
  return std::clamp(there.speed - excess / slope, 0.01 * there.speed, there.speed * (1 - 1e-6));
}

void StopWindow::climb(std::size_t node, std::vector<double>& cap) const {
  const LawRow& law = law_row(law_);
  for (std::size_t i = node; i + 2 < cap.size(); ++i) {
    const double reached = law.reach(cap[i], limits_.length[i], limits_.dynamics_of(i).up);
    if (reached >= cap[i + 1]) return;
    cap[i + 1] = reached;
  }
}

std::size_t StopWindow::lower_where_too_fast(const MotionPlan& plan, Step step, std::vector<double>& cap) const {
  std::size_t count = 0;
  for_each_too_fast(plan, [&](std::size_t node, const PhaseState& there, double excess) {
    ++count;
    if (way_[node] == 0) {
      cap[node] = 0;
    } else if (step == Step::newton) {
      cap[node] = std::min(cap[node], slower(there, node, excess));
    } else if (cap[node] >= there.speed * (1 - 1e-6)) {
      cap[node] = std::min(cap[node], slower(there, node, excess) * (1 - kMargin));
      climb(node, cap);
    }
    return true;
  });
  return count;
}

}  // namespace toolpace::detail
