#include "toolpace/path/commanded.h"

#include <algorithm>
#include <cmath>

namespace toolpace {
namespace {

/// The speed along a direction at which one of the axes runs as fast as it may.
double rapid_speed(const AxisVector& direction, const CommandOptions& options) {
  double speed = options.path_speed;
  for (Eigen::Index k = 0; k < direction.size(); ++k) {
    const double share = std::abs(direction[k]);
    if (share > 0) speed = std::min(speed, options.rapid_speed[k] / share);
  }
  return speed;
}

}  // namespace

double tolerance_of(const MoveMode& mode, const Rounding& rounding) {
  if (is_exact(mode.control)) return 0.0;
  if (mode.control == PathControl::blend) return mode.tolerance > 0 ? mode.tolerance : rounding.tolerance;
  return rounding.everywhere ? rounding.tolerance : 0.0;
}

Commands command_path(const Path& path, const Moves& moves, const CommandOptions& options) {
  Commands commands(path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    Command& c = commands[i];
    const std::uint32_t row = path.move[i];
    const MoveMode& mode = moves.modes[moves.mode[row]];
    c.tolerance = tolerance_of(mode, options.rounding);
    c.control = mode.control;
    c.line = moves.line[row];
    if (moves.kind[row] == MoveKind::rapid) {
      // On a corner curve between two rapids the direction turns, and the axes' limits are the curve's own.
      c.speed = path.kind[i] == SegmentKind::line ? rapid_speed(start_direction(path, i), options) : options.path_speed;
      c.speed *= options.rapid_override;
      c.cause = Cause::rapid;
    } else {
      c.feed =
          (is_rotary_only(path, i) ? moves.feed[row] / kRadiansPerDegree : moves.feed[row]) * options.feed_override;
      c.speed = std::min(options.path_speed, c.feed);
      c.cause = options.path_speed < c.feed ? Cause::path_speed : Cause::feed;
    }
  }
  return commands;
}

}  // namespace toolpace
