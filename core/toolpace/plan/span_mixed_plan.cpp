#include "toolpace/plan/span_mixed_plan.h"

#include <algorithm>
#include <cmath>

#include "toolpace/plan/phase_writer.h"
#include "toolpace/plan/span_emit.h"
#include "toolpace/plan/span_tilt.h"

namespace toolpace::detail {
namespace {

/// Rounds of taking tilts away before a pass is given up.
constexpr std::size_t kMostRepairs = 5;
/// Shares of the speeds and places by which phases may miss each other.
constexpr double kSpeedGap = 1e-10, kPlaceGap = 1e-11;

bool meets_caps(const MixedHull& hull) {
  return hull.entries.size() < 2 || (hull.entries[1].bridge.leave >= 0 && hull.entries.back().bridge.meet <= 0);
}

/// Whether each phase ends where the next one begins.
bool is_continuous(const std::vector<Phase>& phases, double top, double length) {
  for (std::size_t i = 0; i + 1 < phases.size(); ++i) {
    const PhaseState end = evaluate(phases[i], phases[i].duration);
    const Phase& next = phases[i + 1];
    if (!(std::abs(end.speed - next.speed) <= kSpeedGap * top)) return false;
    if (!(std::abs(end.distance - next.distance) <= kPlaceGap * length)) return false;
  }
  return true;
}

}  // namespace

double MixedPlanner::emit(const std::vector<Kernel>& kernels, std::vector<Phase>& phases) const {
  phases.clear();
  phases.reserve(4 * hull_.entries.size());
  PhaseWriter writer(phases);
  emit_hull(kernels, hull_, writer);
  return writer.time();
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
bool MixedPlanner::keeps_caps(std::vector<Kernel>& kernels, double& time) {
  SpanBounds all;
  for (const SpanBounds& b : hull_.met) all.include(b);
  const SpanLimits limits = all.limits();
  for (std::size_t round = 0; round < kMostRepairs; ++round) {
    if (!build_mixed_hull(kernels, bounds_, hull_) || !meets_caps(hull_)) return false;
    time = emit(kernels, trial_);
    const Broken broken{find_broken(kernels, limits, hull_.entries, trial_), 1 + 2 * round};
    if (broken.kernels.empty()) return true;
    if (drop_tilts(hull_.entries, limits, broken, kernels).empty()) return false;
  }
  return false;
}

bool MixedPlanner::plan(const SpanChain& chain, std::vector<Kernel>& kernels, std::vector<Phase>& phases) {
  part_by_limits(chain, kernels, bounds_);
  const double begin = chain.position[chain.first], length = chain.position[chain.last];
  const double top = std::max_element(kernels.begin(), kernels.end(), [](const Kernel& a, const Kernel& b) {
                       return a.cap < b.cap;
                     })->cap;
  double best = 0;
  if (!keeps_caps(kernels, best) || !is_continuous(trial_, top, std::max(length, begin))) return false;
  phases.swap(trial_);
  for (int pass = 0; pass < passes_ && hull_.entries.size() > 2; ++pass) {
    tilt(kernels);
    double time = 0;
    if (!keeps_caps(kernels, time) || !(time < best) || !is_continuous(trial_, top, length)) break;
    best = time;
    phases.swap(trial_);
  }
  return true;
}

}  // namespace toolpace::detail
