#include "toolpace/plan/span_plan.h"

#include <algorithm>

#include "toolpace/plan/block_plan.h"
#include "toolpace/plan/plan.h"
#include "toolpace/plan/span_emit.h"
#include "toolpace/plan/span_filter.h"
#include "toolpace/plan/span_hull.h"

namespace toolpace::detail {
namespace {

/// Limits that hold in all blocks of [first, last).
SpanLimits smallest_limits(const SpeedLimits& limits, std::size_t first, std::size_t last) {
  SpanLimits all = SpanLimits::of(limits.dynamics_of(first));
  if (limits.dynamics.size() == 1) return all;
  for (std::size_t i = first + 1; i < last; ++i) {
    if (limits.ramp[i] != limits.ramp[i - 1]) all.include(SpanLimits::of(limits.dynamics_of(i)));
  }
  return all;
}

}  // namespace

MotionPlan plan_span_ramps(const SpeedLimits& limits, const Monitor& monitor) {
  const std::vector<double> cap = joined_caps(limits);
  const std::vector<double> square = fastest_squares(limits, cap);
  const std::vector<double> position = node_positions(limits);
  MotionPlan plan;
  PhaseWriter writer(plan.phases);
  std::vector<Kernel> kernels;
  std::vector<HullEntry> hull;
  for (std::size_t first = 0; first < limits.size();) {
    std::size_t last = first + 1;
    while (cap[last] > 0) ++last;
    const SpanLimits all = smallest_limits(limits, first, last);
    select_kernels({limits, cap, square, position, first, last, true}, kernels);
    for (Kernel& k : kernels) {
      k.up_jerk = all.up_jerk;
      k.down_jerk = all.down_jerk;
    }
    build_hull(kernels, &all, hull);
    plan.phases.reserve(plan.phases.size() + 4 * hull.size());
    emit_hull(kernels, hull, writer);
    if (monitor.is_cancelled()) return {};
    first = last;
  }
  return plan;
}

}  // namespace toolpace::detail
