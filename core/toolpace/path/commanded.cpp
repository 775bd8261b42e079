#include "toolpace/path/commanded.h"

#include <algorithm>
#include <cmath>

namespace toolpace {
namespace {

/// The speed along a direction at which one of the axes runs as fast as it may.
double rapid_speed(const AxisVector& direction, const AxisVector& top, double path_speed) {
  double speed = path_speed;
  for (Eigen::Index k = 0; k < direction.size(); ++k) {
    const double share = std::abs(direction[k]);
    if (share > 0) speed = std::min(speed, top[k] / share);
  }
  return speed;
}

/// Overrides that a program holds do not count; what it lowers counts, whatever they are.
class Commander {
 public:
  Commander(const Path& path, const CommandOptions& options) : path_(path), options_(options) {}

  void set_rapid(std::size_t i, const MotionCeiling& ceiling, Command& c) const {
    const double override_now = ceiling.holds_overrides ? 1.0 : options_.rapid_override;
    c.is_rapid = true;
    c.speed = rapid_on(i, options_.rapid_speed, options_.path_speed) * override_now;
    c.cause = Cause::rapid;
    lower(rapid_on(i, ceiling.speed, ceiling.path_speed), c);
  }

  void set_feed(double feed, const MotionCeiling& ceiling, Command& c) const {
    c.feed = feed * (ceiling.holds_overrides ? 1.0 : options_.feed_override);
    c.speed = std::min(options_.path_speed, c.feed);
    c.cause = options_.path_speed < c.feed ? Cause::path_speed : Cause::feed;
    lower(ceiling.path_speed, c);
  }

 private:
  // On a corner curve between two rapids, and where the axes follow the tool's tip, the direction turns, and the axes' limits are
  // the curve's own.
  double rapid_on(std::size_t i, const AxisVector& top, double path_speed) const {
    return path_.kind[i] == SegmentKind::line && path_.chain_of(i) == nullptr
               ? rapid_speed(start_direction(path_, i), top, path_speed)
               : path_speed;
  }

  static void lower(double speed, Command& c) {
    if (!(speed < c.speed)) return;
    c.speed = speed;
    c.cause = Cause::program_limit;
  }

  const Path& path_;
  const CommandOptions& options_;
};

}  // namespace

double tolerance_of(const MoveMode& mode, const Rounding& rounding) {
  if (is_exact(mode.control)) return 0.0;
  if (mode.control == PathControl::blend) return mode.tolerance > 0 ? mode.tolerance : rounding.tolerance;
  return rounding.everywhere ? rounding.tolerance : 0.0;
}

double Commands::top_speed() const {
  double top = 0;
  for (const Command& c : list_) top = std::max(top, c.speed);
  return top;
}

Commands command_path(const Path& path, const Moves& moves, const CommandOptions& options) {
  Commands commands(path.size());
  commands.ceilings = moves.ceilings;
  const Commander commander(path, options);
  for (std::size_t i = 0; i < path.size(); ++i) {
    Command& c = commands[i];
    const std::uint32_t row = path.move[i];
    const MoveMode& mode = moves.modes[moves.mode[row]];
    c.tolerance = tolerance_of(mode, options.rounding);
    c.control = mode.control;
    c.line = moves.line[row];
    c.ceiling = mode.ceiling;
    if (moves.kind[row] == MoveKind::rapid) {
      commander.set_rapid(i, commands.ceiling_of(i), c);
    } else {
      const double feed = moves.feed[row];
      commander.set_feed(is_rotary_only(path, i) ? feed / kRadiansPerDegree : feed, commands.ceiling_of(i), c);
    }
  }
  return commands;
}

}  // namespace toolpace
