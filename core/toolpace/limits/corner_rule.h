#pragma once
/// How fast a machine may cross the node between two segments.

#include <cstdint>
#include <optional>

namespace toolpace {

enum class CornerRule : std::uint8_t { stop, servo, junction, blend, smooth };

struct CornerOptions {
  CornerRule rule = CornerRule::servo;
  std::optional<double> step = {};   ///< [mm/s] replaces the rule: V·|u_{i+1} − u_i| ≤ step
  double tolerance = 0.01;           ///< [mm] blend, smooth
  double junction_deviation = 0.01;  ///< [mm] junction
};

}  // namespace toolpace
