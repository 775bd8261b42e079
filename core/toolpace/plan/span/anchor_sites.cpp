#include "toolpace/plan/span/anchor_sites.h"

#include "toolpace/plan/plan.h"
#include "toolpace/plan/span/filter.h"

namespace toolpace::detail {
namespace {

Span span_of_block(const SpeedLimits& limits, std::size_t i, bool touched) {
  Span s;
  s.length = limits.length[i];
  s.highest_feed = limits.block_cap[i];
  if (touched) s.touched_feed = limits.block_cap[i];
  s.dynamics = limits.dynamics_of(i);
  return s;
}

}  // namespace

double ratio_of(const Dynamics& a, const Dynamics& b) {
  double most = 1.0;
  for (RampLimits Dynamics::*side : {&Dynamics::up, &Dynamics::down}) {
    for (double RampLimits::*value : {&RampLimits::acceleration, &RampLimits::jerk}) {
      const double x = a.*side.*value, y = b.*side.*value;
      if (x != y) most = std::max({most, x / y, y / x});
    }
  }
  return most;
}

bool is_seam(const SpeedLimits& limits, std::size_t node, double ratio) {
  return limits.ramp[node] != limits.ramp[node - 1] &&
         ratio_of(limits.dynamics_of(node - 1), limits.dynamics_of(node)) > ratio;
}

Anchors find_anchors(const SpeedLimits& limits, const std::vector<double>& cap, double seam_ratio) {
  const std::vector<double> square = fastest_squares(limits, cap);
  Anchors a;
  a.position = node_positions(limits);
  const auto add = [&](std::size_t node) {
    a.cap.push_back(cap[node]);
    a.node.push_back(node);
  };
  add(0);
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const double c = cap[i], f = limits.block_cap[i];
    const bool changes = i > 0 && (limits.block_cap[i - 1] != f || c < f);
    const bool touched = changes && square[i] >= c * c * (1 - kTouch);
    if (touched || (i > 0 && is_seam(limits, i, seam_ratio))) add(i);
    const Dynamics& d = limits.dynamics_of(i);
    const double up = d.up.acceleration, down = d.down.acceleration;
    const double share = std::isinf(up) ? 1.0 : up / (up + down);
    const double peak = square[i] + share * (square[i + 1] - square[i] + 2 * down * limits.length[i]);
    const Span s = span_of_block(limits, i, !(peak < f * f * (1 - kTouch)));
    if (a.span.size() < a.node.size()) {
      a.span.push_back(s);
    } else {
      a.span.back().include(s);
    }
  }
  add(limits.size());
  return a;
}

}  // namespace toolpace::detail
