#pragma once
/// What each setting of a real controller would give, found by predicting again.

#include <memory>
#include <string>
#include <vector>

#include "toolpace/controller/prediction.h"

namespace toolpace {

/// One setting with another value.
struct WhatIf {
  std::string setting;  ///< its key
  std::string title;    ///< for people
  std::string unit;     ///< of the two values
  double from = 0, to = 0;
  double cycle_time = 0;  ///< [s] with that
};

/// Tries each setting ten per cent up and down, with the next round value, and with others that are usual; the ones that save
/// most stand first. What an axis is built for (steps, size of buffers) is left as it is.
/// Errors: cancelled.
Result<std::vector<WhatIf>> what_if(const Reading& reading, const ProgramText& text, const ControllerSettings& settings,
                                    const PredictOptions& options, const Monitor& monitor = {});

/// Whether an axis or a board is built for it (steps, size of buffers): it is left as it is.
bool is_built_in_setting(const ControllerParameter& parameter);
/// What people compare a controller with: corners within this [mm], planned as well as can be up to so much motion [s].
inline constexpr double kToleranceOfSetpoints = 0.01;
inline constexpr double kLongestRefined = 20'000;

/// The same program as setpoints of this planner on the limits of the controller [s]: trapezoids across blocks, corners
/// rounded within `tolerance` [mm]. @param refined  corners are timed anew under the axes' own limits (Job::refined), which takes
/// half a millisecond a second of motion. Errors: of run().
Result<double> cycle_time_as_setpoints(std::shared_ptr<const Reading> reading, const ControllerSettings& settings,
                                       double tolerance, bool refined, const Monitor& monitor = {});

/// The next value above that a person would type: 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times a power of ten. @pre value > 0
double next_round_value(double value);

}  // namespace toolpace
