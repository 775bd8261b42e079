#pragma once
/// What the motion plots draw over time: a row of the table is a plot, a column of the values and a part of the readout.

#include <array>

#include "models/units.h"
#include "toolpace/law/phase_bounds.h"
#include "toolpace/limits/speed_limits.h"

namespace toolpace::ui {

struct MotionTrack {
  const char* symbol;
  Quantity quantity;
  int decimals, read_decimals;               ///< in the table of values, and in the line that follows the cursor
  double (*value)(const PhaseState& state);  ///< along the path, or of one axis
  Interval (*range)(const PhaseBounds& bounds);
  /// What a block allows, below and above; not finite where it has no limit.
  Interval (*cap)(const SpeedLimits& limits, std::size_t block);
  bool has_feed;  ///< the programmed feed is drawn behind it
};

enum MotionTrackIndex : std::size_t { kSpeedTrack, kAccelerationTrack, kJerkTrack, kMotionTrackCount };

inline constexpr std::array<MotionTrack, kMotionTrackCount> kMotionTracks = {
    {{"v", Quantity::speed, 3, 2, [](const PhaseState& s) { return s.speed; },
      [](const PhaseBounds& b) { return b.speed; },
      [](const SpeedLimits& l, std::size_t block) {
        return Interval{l.block_cap[block], l.block_cap[block]};
      },
      true},
     {"a", Quantity::acceleration, 1, 0, [](const PhaseState& s) { return s.acceleration; },
      [](const PhaseBounds& b) { return b.acceleration; },
      [](const SpeedLimits& l, std::size_t block) {
        const Dynamics& d = l.dynamics_of(block);
        return Interval{-d.down.acceleration, d.up.acceleration};
      },
      false},
     {"j", Quantity::jerk, 0, 0, [](const PhaseState& s) { return s.jerk; },
      [](const PhaseBounds& b) { return b.jerk; },
      [](const SpeedLimits& l, std::size_t block) {
        const Dynamics& d = l.dynamics_of(block);
        const double most = std::max(d.up.jerk, d.down.jerk);
        return Interval{-most, most};
      },
      false}}};

}  // namespace toolpace::ui
