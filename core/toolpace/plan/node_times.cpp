#include <algorithm>
#include <cmath>

#include "toolpace/plan/increasing_root.h"
#include "toolpace/plan/plan.h"

namespace toolpace {
double time_to_cover(const Phase& p, double way) {
  if (!(way > 0)) return 0.0;
  const auto missing = [&](double t) { return evaluate(p, t).distance - p.distance - way; };
  const double at_end = missing(p.duration);
  if (at_end <= 0) return p.duration;
  if (p.acceleration == 0 && p.rate == 0) return std::min(p.duration, way / p.speed);
  return detail::increasing_root(0.0, p.duration, -way, at_end, missing);
}

std::vector<double> node_times(const SpeedLimits& limits, const MotionPlan& plan) {
  const NodePositions position = node_positions(limits);
  std::vector<double> time(position.size(), 0.0);
  const auto& phases = plan.phases;
  std::size_t k = 0;
  for (std::size_t i = 1; i < position.size() && !phases.empty(); ++i) {
    // From a phase's start to this node.
    const auto way = [&](const Phase& p) { return position.between(p.node, i) - p.distance; };
    while (k + 1 < phases.size() && way(phases[k + 1]) >= 0 && way(phases[k]) > 0) ++k;
    // A node at the seam of two phases is reached when the first of them ends, whatever rest may follow.
    const Phase& p = phases[k];
    time[i] = std::max(p.begin + time_to_cover(p, way(p)), time[i - 1]);
  }
  if (!phases.empty()) time.back() = std::max(time[time.size() - 2], plan.cycle_time());
  return time;
}

std::size_t segment_at(const std::vector<double>& node_time, double time) {
  const auto after = std::upper_bound(node_time.begin(), node_time.end(), time) - node_time.begin();
  return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after - 1, 0, std::ssize(node_time) - 2));
}

}  // namespace toolpace
