#include "toolpace/limits/speed_limits.h"

namespace toolpace {

Cause ramp_cause(const Dynamics& dynamics, const Dynamics& along) {
  const bool by_axis =
      dynamics.up.acceleration < along.up.acceleration || dynamics.down.acceleration < along.down.acceleration;
  return by_axis ? Cause::axis_acceleration : Cause::acceleration;
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
