#pragma once
/// What holds the speed down.

#include <cstdint>
#include <string_view>

namespace toolpace {

enum class Cause : std::uint8_t {
  feed,        ///< of the program, with its override
  rapid,       ///< the machine's rapid traverse, with its override
  path_speed,  ///< the machine's top speed along the path, where the program asks for more
  axis_speed,
  axis_acceleration,
  acceleration,  ///< along the path
  jerk,
  corner,
  curvature,
  lookahead,
  stop,
  dwell
};
inline constexpr std::size_t kCauseCount = 12;

/// "feed", "axis_speed", …: the keys of time_by_limit_s.
std::string_view cause_name(Cause cause);

}  // namespace toolpace
