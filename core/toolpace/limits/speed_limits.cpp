#include "toolpace/limits/speed_limits.h"

#include <utility>

#include "toolpace/limits/dynamics_table.h"

namespace toolpace {

Cause cause_of(const Dynamics& dynamics, const AlongPath& along) {
  const bool by_axes = dynamics.up.acceleration < along.dynamics.up.acceleration ||
                       dynamics.down.acceleration < along.dynamics.down.acceleration;
  return by_axes ? along.of_axes : along.own;
}

SpeedLimits slice(const SpeedLimits& all, std::size_t begin, std::size_t end) {
  const auto cut = [begin](const auto& values, std::size_t last) {
    return std::decay_t<decltype(values)>(values.begin() + static_cast<std::ptrdiff_t>(begin),
                                          values.begin() + static_cast<std::ptrdiff_t>(last));
  };
  SpeedLimits part;
  part.length = cut(all.length, end);
  part.block_cap = cut(all.block_cap, end);
  part.ramp = cut(all.ramp, end);
  part.block_cause = cut(all.block_cause, end);
  part.node_cap = cut(all.node_cap, end + 1);
  part.node_cause = cut(all.node_cause, end + 1);
  DynamicsTable different;
  for (std::uint32_t& ramp : part.ramp) {
    const Cause cause = all.dynamics_cause.empty() ? Cause::acceleration : all.dynamics_cause[ramp];
    ramp = different.add(all.dynamics[ramp], cause);
  }
  std::move(different).give_to(part);
  for (const std::uint32_t node : all.reversals) {
    if (node >= begin && node <= end) part.reversals.push_back(node - static_cast<std::uint32_t>(begin));
  }
  part.node_cap.front() = part.node_cap.back() = 0.0;
  part.node_cause.front() = part.node_cause.back() = Cause::stop;
  return part;
}

}  // namespace toolpace
