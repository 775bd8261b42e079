#include <fmt/format.h>

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

/// The models of grbl, Klipper and Marlin have X, Y and Z: a program that turns more takes longer than they tell.
void warn_of_rotary_axes(Prediction& prediction, const Moves& moves) {
  for (std::size_t row = 0; row < moves.size(); ++row) {
    const AxisVector way = moves.end[row] - moves.begin_of(row);
    if (way.tail<3>().isZero(0.0)) continue;
    const auto& files = moves.files;
    prediction.warnings.push_back(
        {Severity::warning,
         "axis-absent",
         fmt::format("the model of {} has X, Y and Z: what A, B and C take is not counted, from this line on",
                     controller_title(prediction.controller)),
         "",
         {files.empty() ? "" : files[moves.file[row]], moves.line[row], 0},
         {}});
    return;
  }
}

}  // namespace

std::string_view time_limit_name(TimeLimit limit) {
  constexpr std::array<std::string_view, kTimeLimitCount> kTimeLimits = {
      "feed", "rapid", "axis_speed", "acceleration", "corner", "buffer", "link", "stops", "dwell"};
  return kTimeLimits[static_cast<std::size_t>(limit)];
}

Diagnostics not_counted(const ProgramText& text, const ControllerSettings& settings, const std::string& program_name) {
  const auto* klipper = std::get_if<KlipperSettings>(&settings.values);
  const bool counts_extruder = klipper && klipper->has_extruder;
  const bool is_printer = dialect_of(settings.controller) == Dialect::marlin;
  if (!is_printer || counts_extruder || (text.all_codes & kExtruderWord) == 0) return {};
  const char* message = klipper ? "there is no [extruder] in the printer.cfg: E is not counted"
                                : "moves of the extruder alone, and its limits, are not counted";
  return {{Severity::warning, "extruder-not-counted", message, "", {program_name, 0, 0}, {}}};
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
  if (prediction && settings.controller != Controller::linuxcnc) warn_of_rotary_axes(*prediction, reading.moves);
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
