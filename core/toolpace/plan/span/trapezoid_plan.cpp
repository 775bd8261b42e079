#include "toolpace/plan/span/trapezoid_plan.h"

#include <algorithm>
#include <cmath>

#include "toolpace/plan/phase_writer.h"
#include "toolpace/plan/span/exact_place.h"
#include "toolpace/plan/span/filter.h"

namespace toolpace::detail {
namespace {

/// Changes of speed² below this share of it are rounding of the scan's sums.
constexpr double kShortestShare = 1e-13;

class TrapezoidWriter {
 public:
  /// @param position  of the nodes of the stretch that is written
  TrapezoidWriter(std::vector<Phase>& phases, const std::vector<ExactPlace>& position)
      : writer_(phases), position_(position) {}

  void add(std::size_t block, double length, double cap, double square0, double square1, const Dynamics& d) {
    const double up = d.up.acceleration, down = d.down.acceleration;
    const double v0 = std::sqrt(square0), v1 = std::sqrt(square1);
    const double top = std::max(square0, square1);
    double peak_square = square0 + up / (up + down) * (square1 - square0 + 2 * down * length);
    if (peak_square <= top * (1 + kShortestShare)) peak_square = top;
    const bool cruises = peak_square > cap * cap * (1 - kShortestShare);
    if (cruises) peak_square = std::max(cap * cap, top);
    const double rise = std::max(0.0, peak_square - square0) / (2 * up);
    const double fall = std::max(0.0, peak_square - square1) / (2 * down);
    const double peak = cruises ? std::max({cap, v0, v1}) : std::sqrt(peak_square);
    writer_.count_from(block);
    if (rise > 0) writer_.push_straight(0, v0, peak, up);
    if (length - rise - fall > kShortestShare * length) cruise(block, rise, length - fall, peak);
    writer_.count_from(block);
    if (fall > 0) writer_.push_straight(length - fall, peak, v1, -down);
  }

 private:
  /// One that goes on counts from where it began.
  void cruise(std::size_t block, double from, double to, double speed) {
    const Phase* going = writer_.cruise_at(speed);
    const std::size_t node = going != nullptr ? going->node : block;
    const double before = position_[block] - position_[node];
    writer_.count_from(node);
    writer_.push_cruise(before + from, before + to, speed);
  }

  PhaseWriter writer_;
  const std::vector<ExactPlace>& position_;
};

}  // namespace

MotionPlan plan_trapezoids(const SpeedLimits& limits, const std::vector<double>& cap) {
  const std::vector<double> square = fastest_squares(limits, cap);
  std::vector<ExactPlace> position(limits.size() + 1);
  MotionPlan plan;
  // Address space, not memory: what is not written is not there.
  plan.phases.reserve(3 * limits.size());
  TrapezoidWriter writer(plan.phases, position);
  for (std::size_t i = 0, end = 0; i < limits.size(); ++i) {
    if (i == end) {
      for (++end; end < limits.size() && cap[end] > 0;) ++end;
      sum_lengths(limits.length, i, end, position);
    }
    writer.add(i, limits.length[i], limits.block_cap[i], square[i], square[i + 1], limits.dynamics_of(i));
  }
  return plan;
}

}  // namespace toolpace::detail
