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
  dwell,
  program_limit,  ///< a speed or an acceleration that the program lowers: M203, M204, SET_VELOCITY_LIMIT, …
  singularity  ///< the axes, near the pole of two rotary ones: a small change of the tool's direction is a large turn there
};
inline constexpr std::size_t kCauseCount = 14;

/// "feed", "axis_speed", …: the keys of time_by_limit_s.
std::string_view cause_name(Cause cause);

}  // namespace toolpace
