#pragma once
/// Cycle times of a real controller, for what has to choose by them.

#include "toolpace/controller/prediction.h"
#include "toolpace/rewrite/rewrite.h"

namespace toolpace {

/// By the controller's model. The settings have to outlive it. Errors: of predict().
ProgramTimer controller_timer(const ControllerSettings& settings, const PredictOptions& options = {},
                              const Monitor& monitor = {});

}  // namespace toolpace
