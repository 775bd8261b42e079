#include "toolpace/plan/span_plan.h"

#include <algorithm>
#include <optional>

#include "toolpace/plan/anchored_plan.h"
#include "toolpace/plan/plan.h"
#include "toolpace/plan/span_emit.h"
#include "toolpace/plan/span_filter.h"
#include "toolpace/plan/span_hull.h"
#include "toolpace/plan/span_mixed_plan.h"
#include "toolpace/plan/span_tilt.h"

namespace toolpace::detail {
namespace {

/// Rounds of taking tilts away before a stretch goes back to its plan without tilts.
constexpr std::size_t kMostRepairs = 8;

/// Blocks a zone on average, at least: where limits jump from block to block a hull in each gains nothing.
constexpr std::size_t kLeastZone = 10;

/// Rounds of giving up seams between zones before the zones are given up.
constexpr int kMostSeamTrials = 3;

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

  /// @return the end that cannot be crossed at its cap with zero acceleration, and then nothing is added; nothing if all is well
  std::optional<std::size_t> add(const SpanChain& chain) {
    if (!has_one_limit(chain)) {
      select_kernels(chain, kernels_);
      if (mixed_.plan(chain, kernels_, best_)) {
        writer_.splice(best_);
        return std::nullopt;
      }
    }
    const SpanLimits limits = smallest_limits(chain.limits, chain.first, chain.last);
    select_kernels(chain, kernels_);
    if (!build_hull(kernels_, limits, hull_)) return chain.last;
    // From a rest, or to one, there is always a way.
    if (hull_[1].bridge.leave < 0) return chain.first;
    if (hull_.back().bridge.meet > 0) return chain.last;
    best_.clear();
    if (hull_.size() > 2 && passes_ > 0) improve(limits);
    if (best_.empty()) emit(limits, best_);
    writer_.splice(best_);
    return std::nullopt;
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

/// What came of planning from seam to seam.
struct Pieces {
  MotionPlan plan;
  std::vector<std::size_t> broken_seams;  ///< nodes that cannot be seams; the plan is worth nothing then
};

/// Plans from seam to seam; `is_seam(node)` for inner nodes.
template <class F>
Pieces plan_pieces(const SpeedLimits& limits, const std::vector<double>& cap, int passes, const Monitor& monitor,
                   F&& is_seam) {
  const std::vector<double> square = fastest_squares(limits, cap);
  const std::vector<double> position = node_positions(limits);
  Pieces pieces;
  StretchPlanner planner(passes, pieces.plan.phases);
  for (std::size_t first = 0; first < limits.size();) {
    std::size_t last = first + 1;
    while (last < limits.size() && !is_seam(last)) ++last;
    if (const auto broken = planner.add({limits, cap, square, position, first, last})) {
      pieces.broken_seams.push_back(*broken);
    }
    if (monitor.is_cancelled()) return pieces;
    first = last;
  }
  return pieces;
}

bool widens(double& low, double& high, double value, double ratio) {
  low = std::min(low, value);
  high = std::max(high, value);
  return high > low * ratio;
}

/// Ranges of the ramp limits in a zone.
struct ZoneRange {
  Dynamics low, high;

  /// Takes a block in; false where the limits then differ by more than `ratio`.
  bool include(const Dynamics& d, double ratio) {
    const bool a = widens(low.up.acceleration, high.up.acceleration, d.up.acceleration, ratio);
    const bool b = widens(low.up.jerk, high.up.jerk, d.up.jerk, ratio);
    const bool c = widens(low.down.acceleration, high.down.acceleration, d.down.acceleration, ratio);
    const bool e = widens(low.down.jerk, high.down.jerk, d.down.jerk, ratio);
    return !(a || b || c || e);
  }
};

/// The same chain with one set of ramp limits a zone, the smallest ones in it. Zones end at rests.
/// @param joined  nodes where no zone may end
SpeedLimits unite_zones(const SpeedLimits& limits, const std::vector<double>& cap, double ratio,
                        const std::vector<bool>& joined) {
  SpeedLimits zoned = limits;
  zoned.dynamics.clear();
  zoned.dynamics_cause.clear();
  for (std::size_t first = 0; first < limits.size();) {
    ZoneRange range{limits.dynamics_of(first), limits.dynamics_of(first)};
    Dynamics smallest = range.low;
    std::size_t last = first + 1;
    for (; last < limits.size() && cap[last] > 0; ++last) {
      if (limits.ramp[last] == limits.ramp[last - 1]) continue;
      if (!range.include(limits.dynamics_of(last), ratio) && !joined[last]) break;
      smallest = range.low;
    }
    std::fill(zoned.ramp.begin() + static_cast<std::ptrdiff_t>(first),
              zoned.ramp.begin() + static_cast<std::ptrdiff_t>(last),
              static_cast<std::uint32_t>(zoned.dynamics.size()));
    zoned.dynamics.push_back(smallest);
    first = last;
  }
  return zoned;
}

}  // namespace

MotionPlan plan_span_ramps(const SpeedLimits& limits, const std::vector<double>& cap, int passes,
                           const Monitor& monitor) {
  auto pieces = plan_pieces(limits, cap, passes, monitor, [&](std::size_t node) { return cap[node] == 0; });
  if (!pieces.broken_seams.empty() || monitor.is_cancelled()) return {};
  return std::move(pieces.plan);
}

MotionPlan plan_zoned_ramps(const SpeedLimits& limits, const std::vector<double>& cap, double ratio, int passes,
                            const Monitor& monitor) {
  std::vector<bool> joined(limits.size() + 1, false);
  for (int trial = 0; trial < kMostSeamTrials; ++trial) {
    const SpeedLimits zoned = unite_zones(limits, cap, ratio, joined);
    if (zoned.dynamics.size() * kLeastZone > limits.size()) return {};
    const std::vector<double> settled = settle_where_limits_change(zoned, cap);
    auto pieces = plan_pieces(zoned, settled, passes, monitor, [&](std::size_t node) {
      return settled[node] == 0 || zoned.ramp[node] != zoned.ramp[node - 1];
    });
    if (monitor.is_cancelled()) return {};
    if (pieces.broken_seams.empty()) return std::move(pieces.plan);
    for (const std::size_t node : pieces.broken_seams) joined[node] = true;
  }
  return {};
}

}  // namespace toolpace::detail
