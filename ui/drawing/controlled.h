#pragma once
/// What the controller that is chosen does with the program, made ready by a worker.

#include <memory>
#include <optional>
#include <vector>

#include "drawing/planned.h"
#include "models/controller_model.h"
#include "toolpace/controller/prediction.h"

namespace toolpace::ui {

/// A program on a controller. Immutable.
struct Controlled {
  SharedControllerText asked;              ///< whose settings these were
  PredictOptions supply;                   ///< how its blocks came
  std::shared_ptr<const Reading> reading;  ///< in the controller's dialect
  std::shared_ptr<const toolpace::ProgramText> text;
  Prediction prediction;          ///< without its stages
  std::vector<double> line_time;  ///< [s] by NC line, from 1; entry 0 is unused
  Planned motion;                 ///< none of LinuxCNC, which runs two blocks at a time at corners
  Diagnostics problems;           ///< what the controller refuses, where it breaks limits, and what is not counted
};

/// What the window shows of it.
struct ControllerView {
  SharedControllerText chosen;              ///< null: Toolpace's own plan
  PredictOptions supply = {};               ///< how blocks come to it
  std::shared_ptr<const Controlled> found;  ///< maybe of settings before; null: not known yet, or it cannot be
  std::optional<double> as_setpoints = {};  ///< [s] as Toolpace's setpoints on the same limits
  std::optional<Error> failure = {};        ///< why nothing is found
  bool is_stale = false;                    ///< `found` is not yet of the present text and settings
};

}  // namespace toolpace::ui
