#pragma once
/// Everything that the window says of one instant of a plan.

#include <cstdint>
#include <optional>

#include "toolpace/pipeline/job.h"

namespace toolpace::ui {

struct Instant {
  double time = 0;                           ///< [s]
  PhaseState state = {};                     ///< along the way that is run
  AxisVector position = AxisVector::Zero();  ///< [mm, rad]
  std::size_t block = 0;                     ///< segment of the path
  std::uint32_t line = 0;                    ///< NC line of the program itself, also while it rests; 0 = none
  std::optional<Cause> cause;                ///< what holds the speed down
};

/// Whether there is a motion to ask about.
bool has_motion(const Outcome& outcome);

/// Row of the moves whose dwell, tool change or stop at a node it is, while the machine rests there for it; nothing before
/// it arrives and from when it goes on.
std::optional<std::uint32_t> resting_move(const Outcome& outcome, std::size_t node, double time);

/// The time is held within the plan; where it is no number, 0. Nothing without a motion.
std::optional<Instant> instant_at(const Outcome& outcome, double time);

}  // namespace toolpace::ui
