#pragma once
/// The models, one file each.

#include <type_traits>

#include "toolpace/controller/prediction.h"

namespace toolpace::detail::controller {

struct ModelInput {
  const Reading& reading;
  const ProgramText& text;
  const ControllerSettings& settings;
  const PredictOptions& options;
  const Monitor& monitor;
};

/// Takes the rows of a program one after the other, and reports how far it is. Errors: of take(row), if it has any; cancelled.
template <class Take>
Result<void> for_each_row(const ModelInput& input, const Take& take) {
  const std::size_t rows = input.reading.moves.size();
  for (std::size_t row = 0; row < rows; ++row) {
    if (row % kReportEvery == 0) {
      if (input.monitor.is_cancelled()) return tl::unexpected(cancelled_error());
      input.monitor.report(static_cast<double>(row) / static_cast<double>(rows));
    }
    if constexpr (std::is_void_v<decltype(take(row))>) {
      take(row);
    } else if (auto done = take(row); !done) {
      return done;
    }
  }
  return {};
}

Result<Prediction> predict_grbl(const ModelInput& input);  ///< grbl and grblHAL
Result<Prediction> predict_klipper(const ModelInput& input);
Result<Prediction> predict_marlin(const ModelInput& input);
Result<Prediction> predict_linuxcnc(const ModelInput& input);

}  // namespace toolpace::detail::controller
