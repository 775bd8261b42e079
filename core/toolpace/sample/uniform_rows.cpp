#include "toolpace/sample/uniform_rows.h"

#include <cmath>

#include "toolpace/sample/motion.h"

namespace toolpace {
namespace {

constexpr double kMargin = 4;       // rows on either side, which differences of third order reach
constexpr double kWorthwhile = 64;  // rows

}  // namespace

std::vector<UniformRows> uniform_rows(const Path& path, const MotionPlan& plan, double period) {
  std::vector<UniformRows> all;
  if (path.size() == 0) return all;
  Motion motion(path, plan);
  for (const Phase& phase : plan.phases) {
    const double first = std::ceil(phase.begin / period) + kMargin;
    const double end = std::floor((phase.begin + phase.duration) / period) - kMargin;
    if (phase.acceleration != 0 || phase.rate != 0 || end - first < kWorthwhile) continue;
    if (phase.speed != 0) {
      motion.at((first - kMargin + 0.5) * period);
      const std::size_t segment = motion.segment();
      if (!AxisCurve(path).is_straight(segment) || motion.leaves_path()) continue;
      motion.at((end + kMargin - 0.5) * period);
      if (motion.segment() != segment || motion.leaves_path()) continue;
    }
    all.push_back({static_cast<std::size_t>(first), static_cast<std::size_t>(end)});
  }
  return all;
}

}  // namespace toolpace
