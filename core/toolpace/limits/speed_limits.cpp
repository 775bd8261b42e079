#include "toolpace/limits/speed_limits.h"

namespace toolpace {

std::uint32_t add_dynamics(const Dynamics& dynamics, SpeedLimits& limits) {
  if (limits.dynamics.empty() || !(limits.dynamics.back() == dynamics)) {
    const bool by_axis = dynamics.up.acceleration < limits.along.up.acceleration ||
                         dynamics.down.acceleration < limits.along.down.acceleration;
    limits.dynamics.push_back(dynamics);
    limits.dynamics_cause.push_back(by_axis ? Cause::axis_acceleration : Cause::acceleration);
  }
  return static_cast<std::uint32_t>(limits.dynamics.size() - 1);
}

SpeedLimits slice(const SpeedLimits& all, std::size_t begin, std::size_t end) {
  const auto cut = [begin](const auto& values, std::size_t last) {
    return std::decay_t<decltype(values)>(values.begin() + static_cast<std::ptrdiff_t>(begin),
                                          values.begin() + static_cast<std::ptrdiff_t>(last));
  };
  SpeedLimits part{cut(all.length, end),
                   cut(all.block_cap, end),
                   cut(all.ramp, end),
                   cut(all.block_cause, end),
                   cut(all.node_cap, end + 1),
                   cut(all.node_cause, end + 1),
                   {},
                   {},
                   {},
                   all.along,
                   {},
                   {}};
  for (std::uint32_t& ramp : part.ramp) {
    const Dynamics& dynamics = all.dynamics[ramp];
    if (part.dynamics.empty() || !(part.dynamics.back() == dynamics)) {
      part.dynamics.push_back(dynamics);
      if (!all.dynamics_cause.empty()) part.dynamics_cause.push_back(all.dynamics_cause[ramp]);
    }
    ramp = static_cast<std::uint32_t>(part.dynamics.size() - 1);
  }
  for (const std::uint32_t node : all.reversals) {
    if (node >= begin && node <= end) part.reversals.push_back(node - static_cast<std::uint32_t>(begin));
  }
  part.node_cap.front() = part.node_cap.back() = 0.0;
  part.node_cause.front() = part.node_cause.back() = Cause::stop;
  return part;
}

}  // namespace toolpace
