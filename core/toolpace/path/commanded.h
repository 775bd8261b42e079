#pragma once
/// What program and operator command in each segment of a path, before the machine's dynamics have a say.

#include <cstdint>
#include <limits>
#include <vector>

#include "toolpace/base/cause.h"
#include "toolpace/nc/moves.h"
#include "toolpace/path/path.h"

namespace toolpace {

/// How a job treats corners for which its program chose no path mode.
struct Rounding {
  double tolerance = 0.01;  ///< [mm, deg] > 0; also of a G64 that names none
  bool everywhere = true;   ///< also in blocks for which the program chose no path mode; otherwise under G64 alone
};

inline bool is_exact(PathControl control) {
  return control == PathControl::exact_path || control == PathControl::exact_stop;
}

/// How far the motion may leave the path in a block [mm, deg]; 0 where it may not.
double tolerance_of(const MoveMode& mode, const Rounding& rounding);

struct Command {
  double feed = std::numeric_limits<double>::infinity();  ///< of the program, with its override; infinite for rapids
  /// What may be run at most: the feed or the rapid traverse, and the machine's top speed along the path.
  double speed = std::numeric_limits<double>::infinity();
  double tolerance = 0.0;     ///< [mm, deg] see tolerance_of()
  std::uint32_t line = 0;     ///< of the program
  Cause cause = Cause::feed;  ///< what sets `speed`: feed, rapid, path_speed or program_limit
  PathControl control = PathControl::job_default;
  bool is_rapid = false;
  std::uint16_t ceiling = 0;  ///< index into Commands::ceilings
};

/// One a segment, with what the program lowers the machine's limits to. Speeds are in the path's unit: mm/s, deg/s where only
/// rotary axes move.
class Commands {
 public:
  explicit Commands(std::size_t segments) : list_(segments) {}

  std::size_t size() const { return list_.size(); }
  const Command& operator[](std::size_t segment) const { return list_[segment]; }
  Command& operator[](std::size_t segment) { return list_[segment]; }
  auto begin() const { return list_.begin(); }
  auto end() const { return list_.end(); }
  auto begin() { return list_.begin(); }
  auto end() { return list_.end(); }

  /// The highest of all [mm/s]; 0 without segments.
  double top_speed() const;

  const MotionCeiling& ceiling_of(std::size_t segment) const { return ceilings[list_[segment].ceiling]; }

  std::vector<MotionCeiling> ceilings = std::vector<MotionCeiling>(1);

 private:
  std::vector<Command> list_;
};

struct CommandOptions {
  double path_speed = std::numeric_limits<double>::infinity();  ///< the machine's top speed along the path [mm/s]
  AxisVector rapid_speed =
      AxisVector::Constant(std::numeric_limits<double>::infinity());  ///< of each axis [mm/s, rad/s]
  double feed_override = 1.0;                                         ///< on feed moves; 0 < … ≤ 2
  double rapid_override = 1.0;                                        ///< on rapids; 0 < … ≤ 1
  Rounding rounding = {};
};

Commands command_path(const Path& path, const Moves& moves, const CommandOptions& options);

}  // namespace toolpace
