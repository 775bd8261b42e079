#pragma once
/// What drive an axis has, from what it was commanded and what it did.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"
#include "toolpace/limits/servo_axis.h"

namespace toolpace {

/// Of one axis. The model is AxisServo, so that `simulate` with what is found gives the trace again.
struct IdentificationData {
  std::vector<double> commanded;  ///< [mm, rad] a row a period; at rest before and after
  double period = 0.001;          ///< [s]
  std::vector<double> time;       ///< [s] of each measured row, rising; 0 at the first commanded one
  std::vector<double> actual;     ///< [mm, rad]
  /// How well the times are known [s]: 0 = they are those of the setpoints; nothing = not at all, which the fit makes up for.
  std::optional<double> clock_error = 0.0;
  /// What has to be added to the times if both clocks are one: tried where nothing is known of them.
  std::optional<double> same_clock = {};
  double unit = 1.0;  ///< mm or rad of what people call 1: a backlash of a few thousandths of it is looked for
};

struct IdentifiedValue {
  double value = 0;
  double error = 0;          ///< standard error
  bool is_told = false;      ///< whether the trace tells it; if not, value is what fits best and no more
  const char* verdict = "";  ///< why not: "no reversal", …; empty where it is told
};

struct AxisIdentification {
  /// In the order of ServoAxis: position gain [1/s], velocity and acceleration feed-forward, bandwidth [Hz], damping,
  /// backlash [mm, rad], resonance [Hz], its damping.
  std::array<IdentifiedValue, 8> values;
  ServoAxis axis;          ///< `known` with the values that the trace tells
  double noise = 0;        ///< [mm, rad] standard deviation of what the model leaves
  double largest = 0;      ///< [mm, rad] of it
  double clock = 0;        ///< [s] that was added to the times
  double clock_error = 0;  ///< [s] its standard error; 0 where it was held
  std::size_t rows = 0;
};
inline constexpr std::array<const char*, 8> kIdentifiedNames = {
    "position_gain", "velocity_feed_forward", "acceleration_feed_forward", "bandwidth", "damping", "backlash",
    "resonance",     "resonance_damping"};

/// Fits the drive by nonlinear least squares: without and with backlash (where the axis reverses), without and with a
/// resonance (looked for all over the band of the trace), and takes the simplest that explains the trace. Standard errors
/// take the correlation of what is left into account.
///
/// @param known  values that stand where the trace tells none
/// Errors (input): identify-still where the axis hardly moves; identify-no-fit where the model does not describe the axis: what
/// is left is more than a fifth of the following error, or the search does not end; cancelled.
Result<AxisIdentification> identify_axis(const IdentificationData& data, const ServoAxis& known,
                                         const Monitor& monitor = {});

}  // namespace toolpace
