#include "toolpace/plan/span_plan.h"

#include <algorithm>

#include "toolpace/plan/plan.h"
#include "toolpace/plan/span_emit.h"
#include "toolpace/plan/span_filter.h"
#include "toolpace/plan/span_hull.h"
#include "toolpace/plan/span_tilt.h"

namespace toolpace::detail {
namespace {

/// Rounds of taking tilts away before a stretch goes back to its plan without tilts.
constexpr std::size_t kMostRepairs = 8;

/// Stretches of no more kernels than this get a few passes more: they cost nothing there and gain some tenths of a percent.
constexpr std::size_t kShortStretch = 20000;
constexpr int kShortPasses = 3;

/// Limits that hold in all blocks of [first, last).
SpanLimits smallest_limits(const SpeedLimits& limits, std::size_t first, std::size_t last) {
  SpanLimits all = SpanLimits::of(limits.dynamics_of(first));
  if (limits.dynamics.size() == 1) return all;
  for (std::size_t i = first + 1; i < last; ++i) {
    if (limits.ramp[i] != limits.ramp[i - 1]) all.include(SpanLimits::of(limits.dynamics_of(i)));
  }
  return all;
}

/// Plans the stretches from one rest to the next; keeps its buffers between them.
class StretchPlanner {
 public:
  StretchPlanner(int passes, MotionPlan& plan) : passes_(passes), plan_(plan), writer_(plan.phases) {}

  void add(const SpanChain& chain) {
    const SpanLimits limits = smallest_limits(chain.limits, chain.first, chain.last);
    select_kernels(chain, kernels_);
    for (Kernel& k : kernels_) {
      k.up_jerk = limits.up_jerk;
      k.down_jerk = limits.down_jerk;
    }
    build_hull(kernels_, &limits, best_);
    best_kernels_ = nullptr;
    if (best_.size() > 2) improve(limits);
    plan_.phases.reserve(std::max(plan_.phases.size() + 4 * best_.size(), plan_.phases.capacity()));
    emit_hull(best_kernels_ != nullptr ? *best_kernels_ : kernels_, best_, writer_);
  }

 private:
  /// Tilts the touched nodes, pass after pass, as long as that saves time.
  void improve(const SpanLimits& limits) {
    double best_time = hull_time(kernels_, best_);
    tilted_ = kernels_;
    next_ = best_;
    const int passes = kernels_.size() <= kShortStretch ? std::max(passes_, kShortPasses) : passes_;
    for (int pass = 0; pass < passes; ++pass) {
      tilt_kernels(next_, limits, tilted_);
      build_hull(tilted_, &limits, next_);
      if (!repair(limits)) return;
      const double time = hull_time(tilted_, next_);
      if (!(time < best_time)) return;
      best_time = time;
      best_.swap(next_);
      next_ = best_;
      chosen_ = tilted_;
      best_kernels_ = &chosen_;
    }
  }

  /// Takes tilts away around caps that the hull passes; false where caps are still broken in the end.
  bool repair(const SpanLimits& limits) {
    for (std::size_t round = 0; round < kMostRepairs; ++round) {
      trial_.clear();
      PhaseWriter writer(trial_);
      emit_hull(tilted_, next_, writer);
      const auto broken = find_broken(tilted_, limits, trial_.data(), trial_.data() + trial_.size());
      if (broken.empty()) return true;
      drop_tilts(next_, broken, 1 + 2 * round, tilted_, changed_);
      if (changed_.empty()) return false;
      rebuild_hull(tilted_, limits, changed_, next_);
    }
    return false;
  }

  int passes_;
  MotionPlan& plan_;
  PhaseWriter writer_;
  std::vector<Kernel> kernels_, tilted_, chosen_;
  const std::vector<Kernel>* best_kernels_ = nullptr;
  std::vector<HullEntry> best_, next_;
  std::vector<Phase> trial_;
  std::vector<std::uint32_t> changed_;
};

}  // namespace

MotionPlan plan_span_ramps(const SpeedLimits& limits, const std::vector<double>& cap, int passes,
                           const Monitor& monitor) {
  const std::vector<double> square = fastest_squares(limits, cap);
  const std::vector<double> position = node_positions(limits);
  MotionPlan plan;
  StretchPlanner planner(passes, plan);
  for (std::size_t first = 0; first < limits.size();) {
    std::size_t last = first + 1;
    while (cap[last] > 0) ++last;
    planner.add({limits, cap, square, position, first, last, true});
    if (monitor.is_cancelled()) return {};
    first = last;
  }
  return plan;
}

}  // namespace toolpace::detail
