#include "toolpace/rewrite/controller_timer.h"

#include <utility>

namespace toolpace {

ProgramTimer controller_timer(const ControllerSettings& settings, const PredictOptions& options,
                              const Monitor& monitor) {
  return [&settings, options, monitor](const Reading& reading, std::string_view text) -> Result<ProgramTime> {
    PredictOptions by_row = options;
    by_row.keeps_blocks = true;
    auto prediction = predict(reading, scan_program(text), settings, by_row, monitor);
    if (!prediction) return tl::unexpected(prediction.error());
    return ProgramTime{prediction->cycle_time, std::move(prediction->row_time)};
  };
}

}  // namespace toolpace
