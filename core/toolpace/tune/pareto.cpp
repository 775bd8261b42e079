#include "toolpace/tune/pareto.h"

#include <algorithm>
#include <cmath>

namespace toolpace {

bool dominates(const Objectives& one, const Objectives& other) {
  const bool knows_vibration = one.vibration && other.vibration;
  if (one.cycle_time > other.cycle_time || one.contour > other.contour) return false;
  if (knows_vibration && *one.vibration > *other.vibration) return false;
  return one.cycle_time < other.cycle_time || one.contour < other.contour ||
         (knows_vibration && *one.vibration < *other.vibration);
}

std::vector<std::size_t> pareto_front(std::span<const Objectives> points) {
  const auto is_same = [](const Objectives& a, const Objectives& b) {
    return a.cycle_time == b.cycle_time && a.contour == b.contour && a.vibration == b.vibration;
  };
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto beats = [&](std::size_t j) { return dominates(points[j], points[i]) || is_same(points[j], points[i]); };
    if (std::any_of(front.begin(), front.end(), beats)) continue;
    std::erase_if(front, [&](std::size_t j) { return dominates(points[i], points[j]); });
    front.push_back(i);
  }
  std::stable_sort(front.begin(), front.end(),
                   [&](std::size_t a, std::size_t b) { return points[a].cycle_time < points[b].cycle_time; });
  return front;
}

std::vector<std::size_t> pareto_front(std::span<const Objectives> points, Flaw flaw) {
  std::vector<Objectives> flat;
  for (const Objectives& p : points) flat.push_back({p.cycle_time, size_of(flaw, p), {}});
  return pareto_front(flat);
}

std::size_t knee_of(std::span<const Objectives> front) {
  const std::vector<std::size_t> line = pareto_front(front, Flaw::contour);
  const Objectives& fastest = front[line.front()];
  const Objectives& slowest = front[line.back()];
  const double time = slowest.cycle_time - fastest.cycle_time, error = fastest.contour - slowest.contour;
  if (!(time > 0) || !(error > 0)) return line.front();
  std::size_t knee = line.front();
  double deepest = 0;
  for (const std::size_t i : line) {
    const double depth =
        1 - (front[i].cycle_time - fastest.cycle_time) / time - (front[i].contour - slowest.contour) / error;
    if (depth <= deepest) continue;
    deepest = depth;
    knee = i;
  }
  return knee;
}

double hypervolume(std::span<const Objectives> points, const Objectives& reference) {
  double area = 0, ceiling = reference.contour;
  for (const std::size_t i : pareto_front(points, Flaw::contour)) {
    const Objectives& p = points[i];
    if (p.cycle_time >= reference.cycle_time) break;
    if (p.contour >= ceiling) continue;
    area += (reference.cycle_time - p.cycle_time) * (ceiling - p.contour);
    ceiling = p.contour;
  }
  return area;
}

}  // namespace toolpace
