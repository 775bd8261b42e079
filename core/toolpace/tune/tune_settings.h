#pragma once
/// The best settings of a real controller for a program, with its own model as the judge.

#include <string>
#include <vector>

#include "toolpace/controller/prediction.h"
#include "toolpace/machine/setup.h"

namespace toolpace {

/// One setting of a controller, and the value that it is best set to.
struct SettingChange {
  std::string setting;  ///< its key
  std::string title;    ///< for people
  std::string unit;     ///< of the two values
  double from = 0, to = 0;
};

struct TunedSettings {
  ControllerSettings settings;  ///< with the changes
  std::vector<SettingChange> changes;
  double before = 0, after = 0;  ///< [s] cycle time by the controller's model
  std::size_t predictions = 0;
};

struct SettingsSearch {
  /// What no setting goes beyond: speeds, accelerations, junction deviation, tolerance of G64 P. Nothing = what the settings have now, so that only what is
  /// no limit is changed.
  std::optional<Setup> allowed = {};
  std::vector<std::string> turned = {};  ///< keys of those that may be changed; empty = all of tunable_settings()
  std::size_t predictions = 400;         ///< that may be made, ≥ 1
  PredictOptions predict = {};
};

/// Keys of the settings that a search may change: limits, and those with other usual values.
std::vector<std::string> tunable_settings(const ControllerSettings& settings);

/// Raises the limits that there are to what is allowed, all at once and one by one, and tries what else is usual of settings that are no
/// limits, again and again as long as that helps; then takes back every change that saves less than a ten-thousandth. What an axis is
/// built for (steps, buffers) stays, and so does what no limit shows and has no usual values. The same input gives the same settings.
/// Errors: of predict() for the settings as they are; cancelled.
Result<TunedSettings> tune_settings(const Reading& reading, const ProgramText& text, const ControllerSettings& settings,
                                    const SettingsSearch& search, const Monitor& monitor = {});

}  // namespace toolpace
