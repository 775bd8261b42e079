#include "toolpace/plan/span_filter.h"

#include <algorithm>
#include <cmath>

namespace toolpace::detail {
namespace {

/// Speeds squared that agree to this share are the same: rounding of sums along the scan.
constexpr double kTouch = 1e-12;

class Selector {
 public:
  Selector(const SpanChain& chain, std::vector<Kernel>& kernels)
      : chain_(chain), limits_(chain.limits), out_(kernels) {}

  void run() {
    out_.clear();
    push_node(chain_.first);
    for (std::size_t i = chain_.first; i < chain_.last; ++i) {
      if (i > chain_.first && is_touched_node(i)) push_node(i);
      if (touches_feed(i)) {
        push_plateau(i);
      } else if (!chain_.uniform) {
        between_.include(SpanLimits::of(limits_.dynamics_of(i)));
      }
    }
    push_node(chain_.last);
  }

 private:
  bool is_touched_node(std::size_t i) const {
    const double c = chain_.cap[i];
    return chain_.square[i] >= c * c * (1 - kTouch) && c < std::min(limits_.block_cap[i - 1], limits_.block_cap[i]);
  }

  /// Whether the optimum's peak inside the block comes up to its top speed.
  bool touches_feed(std::size_t i) const {
    const Dynamics& d = limits_.dynamics_of(i);
    const double up = d.up.acceleration, down = d.down.acceleration, f = limits_.block_cap[i];
    const double here = chain_.square[i], next = chain_.square[i + 1];
    return here + up / (up + down) * (next - here + 2 * down * limits_.length[i]) >= f * f * (1 - kTouch);
  }

  Kernel& push(double position, double speed, std::size_t first, std::size_t last) {
    const SpanLimits near = SpanLimits::of(limits_.dynamics_of(std::min(first, chain_.last - 1)));
    Kernel k{};
    k.left = k.right = k.position = position;
    k.bottom = k.cap = speed;
    k.up_jerk = near.up_jerk;
    k.down_jerk = near.down_jerk;
    k.first_node = static_cast<std::uint32_t>(first);
    k.last_node = static_cast<std::uint32_t>(last);
    k.before = between_;
    between_ = SpanLimits{};
    out_.push_back(k);
    return out_.back();
  }

  void push_node(std::size_t i) { push(chain_.position[i], chain_.cap[i], i, i); }

  void push_plateau(std::size_t i) {
    const double speed = limits_.block_cap[i];
    Kernel& last = out_.back();
    const bool same_limits = chain_.uniform || i == chain_.first || limits_.ramp[i] == limits_.ramp[i - 1];
    if (last.is_plateau() && last.last_node == i && last.bottom == speed && same_limits) {
      last.right = chain_.position[i + 1];
      last.last_node = static_cast<std::uint32_t>(i + 1);
      return;
    }
    Kernel& k = push(chain_.position[i], speed, i, i + 1);
    k.right = chain_.position[i + 1];
    if (!chain_.uniform) k.own = SpanLimits::of(limits_.dynamics_of(i));
  }

  const SpanChain& chain_;
  const SpeedLimits& limits_;
  std::vector<Kernel>& out_;
  SpanLimits between_;
};

}  // namespace

std::vector<double> fastest_squares(const SpeedLimits& limits, const std::vector<double>& cap) {
  const std::size_t n = limits.size();
  std::vector<double> q(n + 1);
  q[0] = cap[0] * cap[0];
  for (std::size_t i = 0; i < n; ++i) {
    q[i + 1] = std::min(cap[i + 1] * cap[i + 1], q[i] + 2 * limits.dynamics_of(i).up.acceleration * limits.length[i]);
  }
  for (std::size_t i = n; i-- > 0;) {
    q[i] = std::min(q[i], q[i + 1] + 2 * limits.dynamics_of(i).down.acceleration * limits.length[i]);
  }
  return q;
}

void select_kernels(const SpanChain& chain, std::vector<Kernel>& kernels) { Selector(chain, kernels).run(); }

}  // namespace toolpace::detail
