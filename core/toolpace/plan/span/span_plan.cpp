#include "toolpace/plan/span/span_plan.h"

#include <algorithm>

#include "toolpace/path/node_positions.h"
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

/// Plans the stretches from one rest to the next; keeps its buffers between them.
class StretchPlanner {
 public:
  StretchPlanner(int passes, std::vector<Phase>& phases) : passes_(passes), mixed_(passes), writer_(phases) {}

  /// @return false where the stretch has no hull, which never happens from rest to rest
  bool add(const SpanChain& chain) {
    writer_.count_from(chain.first);
    if (!has_one_limit(chain)) {
      select_kernels(chain, kernels_);
      if (mixed_.plan(chain, kernels_, best_)) {
        writer_.splice(best_);
        return true;
      }
    }
    const SpanLimits limits = smallest_limits(chain.limits, chain.first, chain.last);
    select_kernels(chain, kernels_);
    if (!build_hull(kernels_, limits, hull_) || hull_[1].bridge.leave < 0 || hull_.back().bridge.meet > 0) return false;
    best_.clear();
    if (hull_.size() > 2 && passes_ > 0) improve(limits);
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
    return writer.time();
  }

  /// Tilts the touched nodes, pass after pass, as long as that saves time.
  void improve(const SpanLimits& limits) {
    double best_time = hull_time(kernels_, limits, hull_);
    const int passes = kernels_.size() <= kShortStretch ? std::max(passes_, kShortPasses) : passes_;
    for (int pass = 0; pass < passes; ++pass) {
      if (pass == 0) plain_ = hull_;
      tilt_kernels(hull_, limits, kernels_);
      const double time = build_hull(kernels_, limits, hull_) ? emit_within_caps(limits) : -1.0;
      if (hull_[1].bridge.leave < 0 || hull_.back().bridge.meet > 0) break;
      if (time < 0 || !(time < best_time)) break;
      best_time = time;
      best_.swap(trial_);
    }
    if (!best_.empty()) return;
    drop_all_tilts(limits, kernels_);
    hull_.swap(plain_);
  }

  /// Writes the hull; takes tilts away around caps that it passes. Negative where caps are still broken in the end.
  double emit_within_caps(const SpanLimits& limits) {
    for (std::size_t round = 0; round < kMostRepairs; ++round) {
      const double time = emit(limits, trial_);
      Broken broken{find_broken(kernels_, limits, hull_, trial_), 1 + 2 * round};
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

}  // namespace

MotionPlan plan_span_ramps(const SpeedLimits& limits, const std::vector<double>& cap, int passes,
                           const Monitor& monitor) {
  const std::vector<double> square = fastest_squares(limits, cap);
  std::vector<double> position(limits.size() + 1);
  MotionPlan plan;
  StretchPlanner planner(passes, plan.phases);
  for (std::size_t first = 0; first < limits.size();) {
    std::size_t last = first + 1;
    while (last < limits.size() && cap[last] > 0) ++last;
    sum_lengths(limits.length, first, last, position);
    if (monitor.is_cancelled() || !planner.add({limits, cap, square, position, first, last})) return {};
    first = last;
  }
  return plan;
}

}  // namespace toolpace::detail
