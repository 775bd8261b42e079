#pragma once
/// The flags of every command that asks a real controller's model.

#include <optional>
#include <string>

#include "command_line.h"
#include "toolpace/controller/prediction.h"

namespace toolpace::cli {

struct ControllerFlags {
  std::string controller, settings;
  std::optional<double> baud, block_time_ms;

  /// @param need  whether the settings file has to be given
  void add_to(Command& command, Need need);

  bool is_given() const { return !settings.empty(); }

  /// Errors: usage, of read_controller_settings().
  Result<ControllerSettings> read_settings() const;
  /// Errors: usage.
  Result<PredictOptions> options() const;
};

}  // namespace toolpace::cli
