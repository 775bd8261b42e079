#include "toolpace/base/cause.h"

#include <array>

namespace toolpace {

std::string_view cause_name(Cause cause) {
  static constexpr std::array<std::string_view, kCauseCount> names = {
      "feed",      "rapid",     "path_speed", "axis_speed", "axis_acceleration", "acceleration", "jerk", "corner",
      "curvature", "lookahead", "stop",       "dwell",      "program_limit",     "singularity"};
  return names[static_cast<std::size_t>(cause)];
}

}  // namespace toolpace
