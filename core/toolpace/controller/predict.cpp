#include <array>

#include "toolpace/controller/models.h"
#include "toolpace/controller/prediction.h"

namespace toolpace {
namespace {

using namespace detail::controller;

Result<Prediction> run_model(const ModelInput& input) {
  switch (input.settings.controller) {
    case Controller::klipper: return predict_klipper(input);
    case Controller::marlin: return predict_marlin(input);
    case Controller::linuxcnc: return predict_linuxcnc(input);
    default: return predict_grbl(input);
  }
}

}  // namespace

std::string_view time_limit_name(TimeLimit limit) {
  constexpr std::array<std::string_view, kTimeLimitCount> kTimeLimits = {
      "feed", "rapid", "axis_speed", "acceleration", "corner", "buffer", "link", "stops", "dwell"};
  return kTimeLimits[static_cast<std::size_t>(limit)];
}

Dialect dialect_of(Controller controller) {
  switch (controller) {
    case Controller::klipper:
    case Controller::marlin: return Dialect::marlin;
    case Controller::linuxcnc: return Dialect::linuxcnc;
    default: return Dialect::grbl;
  }
}

Result<Prediction> predict(const Reading& reading, const ProgramText& text, const ControllerSettings& settings,
                           const PredictOptions& options, const Monitor& monitor) {
  auto prediction = run_model({reading, text, settings, options, monitor});
  if (!prediction || (!options.baud && !options.block_time)) return prediction;
  PredictOptions always_there = options;
  always_there.baud = always_there.block_time = std::nullopt;
  always_there.keeps_blocks = always_there.keeps_motion = false;
  const auto unhindered = run_model({reading, text, settings, always_there, monitor});
  if (!unhindered) return tl::unexpected(unhindered.error());
  prediction->starved = std::max(0.0, prediction->cycle_time - unhindered->cycle_time);
  return prediction;
}

}  // namespace toolpace
