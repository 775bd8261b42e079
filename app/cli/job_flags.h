#pragma once
/// The flags of every command that plans: machine, law, limits, look-ahead, corners.

#include <optional>
#include <string>

#include "command_line.h"
#include "toolpace/machine/setup.h"

namespace toolpace::cli {

struct JobFlags {
  std::string machine, law, lookahead, ramps, corner;
  std::optional<double> tacc_ms, tdec_ms, am, dm, jm, jd, vmax, corner_step, tolerance, junction_deviation;
  std::optional<double> override_percent, rapid_percent, period_ms, hold_at;

  void add_to(Command& command);

  /// The machine file (or the defaults) with the flags on top. Usage and io errors.
  Result<Setup> setup() const;
};

}  // namespace toolpace::cli
