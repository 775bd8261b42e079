#pragma once
/// The models, one file each.

#include "toolpace/controller/prediction.h"

namespace toolpace::detail::controller {

struct ModelInput {
  const Reading& reading;
  const ProgramText& text;
  const ControllerSettings& settings;
  const PredictOptions& options;
  const Monitor& monitor;
};

Result<Prediction> predict_grbl(const ModelInput& input);  ///< grbl and grblHAL
Result<Prediction> predict_klipper(const ModelInput& input);
Result<Prediction> predict_marlin(const ModelInput& input);
Result<Prediction> predict_linuxcnc(const ModelInput& input);

}  // namespace toolpace::detail::controller
