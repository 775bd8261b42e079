#include "toolpace/plan/span/filter.h"

#include <algorithm>
#include <cmath>

namespace toolpace::detail {
namespace {

/// Speeds squared that agree to this share are the same: rounding of sums along the scan.

class Selector {
 public:
  Selector(const SpanChain& chain, std::vector<Kernel>& kernels)
      : chain_(chain), limits_(chain.limits), out_(kernels) {}

  void run() {
    out_.clear();
    out_.reserve(chain_.last - chain_.first + 2);
    push_node(chain_.first);
    for (std::size_t i = chain_.first; i < chain_.last; ++i) {
      if (i > chain_.first && (is_touched_node(i) || is_border(i))) push_node(i);
      if (touches_feed(i)) push_plateau(i);
    }
    push_node(chain_.last);
  }

 private:
  bool is_touched_node(std::size_t i) const {
    const double c = chain_.cap[i];
    return chain_.square[i] >= c * c * (1 - kTouch) && c < std::min(limits_.block_cap[i - 1], limits_.block_cap[i]);
  }

  /// Whether a plateau that begins or ends here borders on a faster block.
  bool is_border(std::size_t i) const {
    const double c = chain_.cap[i], before = limits_.block_cap[i - 1], after = limits_.block_cap[i];
    if (before > after) return c == after && touches_feed(i);
    return after > before && c == before && out_.back().is_plateau() && out_.back().last_node == i;
  }

  /// Whether the optimum's peak inside the block comes up to its top speed.
  bool touches_feed(std::size_t i) const {
    const Dynamics& d = limits_.dynamics_of(i);
    const double up = d.up.acceleration, down = d.down.acceleration, f = limits_.block_cap[i];
    const double here = chain_.square[i], next = chain_.square[i + 1];
    return here + up / (up + down) * (next - here + 2 * down * limits_.length[i]) >= f * f * (1 - kTouch);
  }

  void push_node(std::size_t i) {
    const auto node = static_cast<std::uint32_t>(i);
    const ExactPlace at = chain_.position[i];
    const double speed = chain_.cap[i];
    out_.push_back({at, at, speed, at, speed, 0.0, at, node, node});
  }

  void push_plateau(std::size_t i) {
    const double speed = limits_.block_cap[i];
    const ExactPlace end = chain_.position[i + 1];
    const auto node = static_cast<std::uint32_t>(i);
    Kernel& last = out_.back();
    if (last.is_plateau() && last.last_node == node && last.bottom == speed) {
      last.right = last.end = end;
      last.last_node = node + 1;
      return;
    }
    const ExactPlace begin = chain_.position[i];
    out_.push_back({begin, end, speed, begin, speed, 0.0, end, node, node + 1});
  }

  const SpanChain& chain_;
  const SpeedLimits& limits_;
  std::vector<Kernel>& out_;
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
