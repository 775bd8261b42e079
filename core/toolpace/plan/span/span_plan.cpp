#include "toolpace/plan/span/span_plan.h"

#include <algorithm>
#include <utility>

#include "toolpace/plan/span/emit.h"
#include "toolpace/plan/span/filter.h"
#include "toolpace/plan/span/hull.h"
#include "toolpace/plan/span/mixed_plan.h"
#include "toolpace/plan/span/tilt.h"

namespace toolpace::detail {
namespace {

/// Rounds of taking tilts away before a stretch goes back to its plan without tilts.
constexpr std::size_t kMostRepairs = 8;

/// Stretches of no more kernels than this get a few passes more: they cost nothing there and gain some tenths of a percent.
constexpr std::size_t kShortStretch = 20000;
constexpr int kShortPasses = 3;

/// Stretches with turns that have no hull, before a chain is planned without turns.
constexpr int kMostRepairedTurns = 4;

/// Limits that hold in all blocks of [first, last).
SpanLimits smallest_limits(const SpeedLimits& limits, std::size_t first, std::size_t last) {
  Dynamics all = limits.dynamics_of(first);
  const auto include = [](RampLimits& a, const RampLimits& b) {
    a.acceleration = std::min(a.acceleration, b.acceleration);
    a.jerk = std::min(a.jerk, b.jerk);
  };
  for (std::size_t i = first + 1; i < last && limits.dynamics.size() > 1; ++i) {
    if (limits.ramp[i] == limits.ramp[i - 1]) continue;
    include(all.up, limits.dynamics_of(i).up);
    include(all.down, limits.dynamics_of(i).down);
  }
  return {{all.up.acceleration, all.up.jerk}, {all.down.acceleration, all.down.jerk}};
}

/// Accelerations with which a stretch begins and ends; 0 = at rest.
struct TurnsAtEnds {
  double begin = 0.0, end = 0.0;  ///< [mm/s²]
};

/// Plans the stretches from one rest to the next; keeps its buffers between them.
class StretchPlanner {
 public:
  StretchPlanner(int passes, std::vector<Phase>& phases) : passes_(passes), mixed_(passes), writer_(phases) {}

  /// @return false where the stretch has no hull, which never happens from rest to rest without turns
  bool add(const SpanChain& chain, const TurnsAtEnds& turns) {
    const SpanLimits limits = smallest_limits(chain.limits, chain.first, chain.last);
    const auto select = [&] {
      select_kernels(chain, kernels_);
      if (turns.begin > 0 || turns.end > 0) tilt_ends(turns.begin, turns.end, limits, kernels_);
    };
    if (!has_one_limit(chain)) {
      select();
      if (mixed_.plan(chain, kernels_, best_)) {
        writer_.splice(best_);
        return true;
      }
    }
    select();
    if (!build_hull(kernels_, limits, hull_)) return false;
    best_.clear();
    if (hull_.size() > 2 && passes_ > 0) improve(limits, chain.position);
    if (best_.empty()) emit(limits, best_);
    writer_.splice(best_);
    return true;
  }

 private:
  static bool has_one_limit(const SpanChain& chain) {
    for (std::size_t i = chain.first + 1; i < chain.last; ++i) {
      if (chain.limits.ramp[i] != chain.limits.ramp[i - 1]) return false;
    }
    return true;
  }

  double emit(const SpanLimits& limits, std::vector<Phase>& phases) const {
    phases.clear();
    phases.reserve(4 * hull_.size());
    PhaseWriter writer(phases);
    emit_hull(kernels_, limits, hull_, writer);
    begin_at_rest(phases);
    return writer.time();
  }

  /// Tilts the touched nodes, pass after pass, as long as that saves time.
  void improve(const SpanLimits& limits, const std::vector<ExactPlace>& position) {
    double best_time = hull_time(kernels_, limits, hull_);
    const int passes = kernels_.size() <= kShortStretch ? std::max(passes_, kShortPasses) : passes_;
    for (int pass = 0; pass < passes; ++pass) {
      if (pass == 0) plain_ = hull_;
      tilt_kernels(hull_, limits, kernels_);
      const double time = build_hull(kernels_, limits, hull_) ? emit_within_caps(limits, position) : -1.0;
      if (time < 0 || !(time < best_time)) break;
      best_time = time;
      best_.swap(trial_);
    }
    if (!best_.empty()) return;
    drop_all_tilts(limits, kernels_);
    hull_.swap(plain_);
  }

  /// Writes the hull; takes tilts away around caps that it passes. Negative where caps are still broken in the end.
  double emit_within_caps(const SpanLimits& limits, const std::vector<ExactPlace>& position) {
    for (std::size_t round = 0; round < kMostRepairs; ++round) {
      const double time = emit(limits, trial_);
      Broken broken{find_broken(kernels_, limits, hull_, {trial_, position}), 1 + 2 * round};
      if (broken.kernels.empty()) return time;
      const auto changed = drop_tilts(hull_, limits, broken, kernels_);
      if (changed.empty() || !rebuild_hull(kernels_, limits, changed, hull_)) return -1.0;
    }
    return -1.0;
  }

  int passes_;
  MixedPlanner mixed_;
  PhaseWriter writer_;
  std::vector<Kernel> kernels_;
  std::vector<HullEntry> hull_, plain_;
  std::vector<Phase> trial_, best_;
};

/// Plans a chain with given turns, all of which it makes.
class ChainPlanner {
 public:
  ChainPlanner(const SpeedLimits& limits, const std::vector<double>& cap, const std::vector<Turn>& turns)
      : limits_(limits), turns_(turns), cap_(cap), position_(limits.size() + 1) {
    for (const Turn& turn : turns) cap_[turn.node] = 0.0;
    square_ = fastest_squares(limits, cap_);
  }

  /// @return empty when cancelled, and where a stretch has no hull
  MotionPlan run(int passes, const Monitor& monitor) {
    MotionPlan plan;
    StretchPlanner planner(passes, plan.phases);
    std::size_t next = 0;  // turn
    for (std::size_t first = 0; first < limits_.size();) {
      std::size_t last = first + 1;
      while (last < limits_.size() && cap_[last] > 0) ++last;
      sum_lengths(limits_.length, first, last, position_);
      TurnsAtEnds ends;
      if (next > 0 && turns_[next - 1].node == first) ends.begin = turns_[next - 1].acceleration;
      if (next < turns_.size() && turns_[next].node == last) ends.end = turns_[next++].acceleration;
      if (monitor.is_cancelled()) return {};
      if (!planner.add({limits_, cap_, square_, position_, first, last}, ends)) {
        failed_ = {first, last};
        return {};
      }
      first = last;
    }
    return plan;
  }

  /// Whether a turn is at an end of the stretch that has no hull.
  bool is_to_blame(const Turn& turn) const { return turn.node == failed_.first || turn.node == failed_.second; }

 private:
  const SpeedLimits& limits_;
  const std::vector<Turn>& turns_;
  std::vector<double> cap_, square_;
  std::vector<ExactPlace> position_;
  std::pair<std::size_t, std::size_t> failed_ = {0, 0};  ///< nodes
};

}  // namespace

MotionPlan plan_span_ramps(const SpeedLimits& limits, const std::vector<double>& cap, std::vector<Turn> turns,
                           int passes, const Monitor& monitor) {
  for (int round = 0;; ++round) {
    ChainPlanner planner(limits, cap, turns);
    MotionPlan plan = planner.run(passes, monitor);
    if (!plan.phases.empty() || turns.empty() || monitor.is_cancelled()) return plan;
    for (Turn& turn : turns) {
      if (planner.is_to_blame(turn)) turn.acceleration = 0;
    }
    if (round == kMostRepairedTurns) turns.clear();
  }
}

}  // namespace toolpace::detail
