#pragma once
/// A plan with everything that the views draw from it, made ready by the worker.

#include <memory>

#include "drawing/contour_scene.h"
#include "drawing/motion_figures.h"
#include "drawing/profile_series.h"
#include "drawing/tube_trace.h"
#include "drawing/vibration_trace.h"
#include "models/timeline.h"
#include "toolpace/servo/servo_simulation.h"
#include "toolpace/verify/report.h"

namespace toolpace::ui {

/// What an independent look at the setpoints found.
struct Proof {
  std::shared_ptr<const Outcome> outcome;
  VerifyReport report;                        ///< of the setpoints, written to a file and read back
  ContourErrors contour;                      ///< of the machine's drives
  double chord_error = 0;                     ///< of the motion, wherever rounded corners led it [mm]
  double bound = 0;                           ///< no plan of the job is faster [s]
  std::shared_ptr<const ContourScene> scene;  ///< the preview with the contour errors in it, along the same geometry
  std::shared_ptr<const VibrationTrace> vibration;  ///< null where no axis has a mode
  std::shared_ptr<const TubeTrace> tube;            ///< null for plans that stay on the programmed path
};

/// All null, or none but the proof.
struct Planned {
  std::shared_ptr<const Timeline> timeline;
  std::shared_ptr<const ContourScene> scene;
  std::shared_ptr<const ProfileSeries> series;
  std::shared_ptr<const Proof> proof;  ///< comes later than the rest

  explicit operator bool() const { return timeline != nullptr; }
};

}  // namespace toolpace::ui
