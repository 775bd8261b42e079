#include "toolpace/plan/span/mixed_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "toolpace/plan/phase_writer.h"
#include "toolpace/plan/span/emit.h"
#include "toolpace/plan/span/tilt.h"

namespace toolpace::detail {
namespace {

/// Rounds of taking tilts away before a pass is given up.
constexpr std::size_t kMostMixedRepairs = 5;
/// Shares of the speeds and places by which phases may miss each other.
constexpr double kSpeedGap = 1e-10, kPlaceGap = 1e-11;

bool meets_caps(const std::vector<Kernel>& kernels, const MixedHull& hull) {
  return hull.entries.size() < 2 || (hull.entries[1].bridge.leave >= kernels.front().tilt &&
                                     hull.entries.back().bridge.meet <= kernels.back().tilt);
}

/// Whether each phase ends where the next one begins.
bool is_continuous(const std::vector<Phase>& phases, double top, const SpanChain& chain) {
  const double length = chain.position[chain.last].high;
  for (std::size_t i = 0; i + 1 < phases.size(); ++i) {
    const PhaseState end = evaluate(phases[i], phases[i].duration);
    const Phase& next = phases[i + 1];
    const double gap = (chain.position[phases[i].node] - chain.position[next.node]) + (end.distance - next.distance);
    if (!(std::abs(end.speed - next.speed) <= kSpeedGap * top)) return false;
    if (!(std::abs(gap) <= kPlaceGap * length)) return false;
  }
  return true;
}

bool is_sound(const SpanChain& chain, const std::vector<Kernel>& kernels, const std::vector<Phase>& phases) {
  double top = 0;
  for (const Kernel& k : kernels) top = std::max(top, k.cap);
  return is_continuous(phases, top, chain);
}

}  // namespace

/// The limits before the kernels are found anew each time: kept, they would stand beside the phases.
bool MixedPlanner::build(const SpanChain& chain, std::vector<Kernel>& kernels) {
  return build_mixed_hull(chain.limits, limits_before(chain, kernels), kernels, hull_) && meets_caps(kernels, hull_);
}

/// Towards the middle of the accelerations with which each touched node is met and left.
void MixedPlanner::tilt(std::vector<Kernel>& kernels) const {
  for (std::size_t e = 1; e + 1 < hull_.entries.size(); ++e) {
    Kernel& k = kernels[hull_.entries[e].kernel];
    if (k.is_plateau()) continue;
    const SpanLimits limits = smaller(hull_.met[e], hull_.met[e + 1]).limits();
    set_tilt(k, suitable_tilt(k, hull_.entries[e].bridge.meet, hull_.entries[e + 1].bridge.leave, limits), limits);
  }
}

/// Writes the hull into trial_, taking tilts away around caps that it passes.
/// @return false where it is no faster than `at_most`, or not sound
bool MixedPlanner::emit_within_caps(const SpanChain& chain, std::vector<Kernel>& kernels, double at_most) {
  SpanBounds all;
  for (const SpanBounds& b : hull_.met) all.include(b);
  const SpanLimits limits = all.limits();
  for (std::size_t round = 0; round < kMostMixedRepairs; ++round) {
    if (!(hull_time(kernels, hull_) < at_most)) return false;
    trial_.clear();
    trial_.reserve(4 * hull_.entries.size());
    PhaseWriter writer(trial_);
    emit_hull(kernels, hull_, writer);
    begin_at_rest(trial_);
    const Broken broken{find_broken(kernels, limits, hull_.entries, {trial_, chain.position}), 1 + 2 * round};
    if (broken.kernels.empty()) return is_sound(chain, kernels, trial_);
    if (drop_tilts(hull_.entries, limits, broken, kernels).empty() || !build(chain, kernels)) return false;
  }
  return false;
}

bool MixedPlanner::plan(const SpanChain& chain, std::vector<Kernel>& kernels, std::vector<Phase>& phases) {
  part_by_limits(chain, kernels);
  if (!build(chain, kernels)) return false;
  double best = hull_time(kernels, hull_);
  bool has_plan = false;
  for (int pass = 0; pass < passes_ && hull_.entries.size() > 2; ++pass) {
    tilt(kernels);
    if (!build(chain, kernels) || !emit_within_caps(chain, kernels, best)) break;
    best = hull_time(kernels, hull_);
    has_plan = true;
    phases.swap(trial_);
  }
  if (has_plan) return true;
  for (std::size_t k = 1; k + 1 < kernels.size(); ++k) {
    if (kernels[k].tilt != 0) set_tilt(kernels[k], 0.0, hull_.met.back().limits());
  }
  if (!build(chain, kernels) || !emit_within_caps(chain, kernels, std::numeric_limits<double>::infinity()))
    return false;
  phases.swap(trial_);
  return true;
}

}  // namespace toolpace::detail
