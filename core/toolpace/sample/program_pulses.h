#pragma once
/// The step pulses of a whole program.

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/limits/machine.h"
#include "toolpace/path/path.h"
#include "toolpace/plan/motion_plan.h"

namespace toolpace {

struct Pulse {
  std::uint64_t ticks = 0;    ///< timer ticks since the start of the program
  std::uint8_t axis = 0;      ///< index into kAxisNames
  std::int8_t direction = 1;  ///< +1 or −1
};

/// A planned motion and when it reaches the path's nodes.
struct TimedMotion {
  const Path& path;
  const MotionPlan& plan;
  const std::vector<double>& node_time;  ///< [s]
};

inline constexpr double kSlowestTimer = 1, kFastestTimer = 1e12;  ///< [Hz]

/// Errors: usage: timer-value.
Result<void> check_timer(double timer_hz);

struct PulseCounts {
  std::uint64_t pulses = 0;
  std::array<std::int64_t, kAxisCount> net = {};  ///< steps in all, with sign
};

/// Pulses in the order of time, in pieces, of every axis with steps_per_unit > 0. An axis counts in whole steps from zero, so
/// it begins at round(position · steps) and has a pulse whenever its exact position crosses the middle between two
/// counts. So the count is within half a step of the exact motion at all times (and a thousandth where it turns), each pulse is
/// rounded to the nearest tick, and the last count is that of the end point.
///
/// @param timer_hz  [Hz] kSlowestTimer … kFastestTimer
/// @param take      gets the pulses; an error of it ends the work
/// @return Errors: usage: no-steppers (no axis has steps), timer-value, timer-too-slow (two pulses of an axis within one
///         tick), timer-too-fast (the program takes more than 2^53 ticks); of `take`; cancelled
Result<PulseCounts> program_pulses(const TimedMotion& motion, const Machine& machine, double timer_hz,
                                   const std::function<Result<void>(const std::vector<Pulse>&)>& take,
                                   const Monitor& monitor = {});

}  // namespace toolpace
