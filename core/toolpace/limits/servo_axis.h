#pragma once
/// The drive of an axis, as machine files describe it: position loop, drive, mechanics. servo/ simulates it.

#include <vector>

namespace toolpace {

/// A natural frequency of the slide on its drive, beside its first one.
struct AxisMode {
  double frequency = 0.0;  ///< [Hz] > 0
  double damping = 0.05;   ///< > 0
  double share = 1.0;      ///< > 0: of the drive's acceleration that shakes it, as a part of the slide's displacement

  bool operator==(const AxisMode&) const = default;
};

/// Defaults: a plain machine tool without feed-forward, 50 1/s (3 m/min per mm of lag), a velocity loop of 100 Hz.
struct ServoAxis {
  double position_gain = 50.0;             ///< Kv [1/s] > 0
  double velocity_feed_forward = 0.0;      ///< 0 … 1: share of the commanded speed that is passed on
  double acceleration_feed_forward = 0.0;  ///< 0 … 1: share of the drive's lag at constant acceleration that is made up
  double bandwidth = 100.0;                ///< natural frequency of the velocity loop [Hz] > 0
  double damping = 0.7;                    ///< of the velocity loop, > 0
  double backlash = 0.0;                   ///< full play between motor and slide [mm, rad]
  double resonance = 0.0;                  ///< first natural frequency of the slide on its drive [Hz]; 0 = stiff
  double resonance_damping = 0.05;         ///< > 0
  std::vector<AxisMode> modes = {};        ///< further ones; the resonance is one of share 1

  bool operator==(const ServoAxis&) const = default;
};

/// All modes of an axis: its resonance first, if it has one.
inline std::vector<AxisMode> modes_of(const ServoAxis& axis) {
  std::vector<AxisMode> all;
  if (axis.resonance > 0) all.push_back({axis.resonance, axis.resonance_damping, 1.0});
  all.insert(all.end(), axis.modes.begin(), axis.modes.end());
  return all;
}
inline bool is_stiff(const ServoAxis& axis) { return !(axis.resonance > 0) && axis.modes.empty(); }

}  // namespace toolpace
