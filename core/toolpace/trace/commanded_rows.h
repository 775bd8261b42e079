#pragma once
/// The positions that were commanded, as a whole: what a trace is laid beside.

#include <array>
#include <filesystem>
#include <vector>

#include "toolpace/base/axes.h"
#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"
#include "toolpace/sample/setpoints.h"

namespace toolpace {

/// Row k stands at k · period; before the first and after the last one the axes rest.
struct CommandedRows {
  double period = 0.001;                                 ///< [s]
  std::array<std::vector<double>, kAxisCount> position;  ///< [mm, rad]; empty where there is no column
  std::vector<std::uint32_t> line;                       ///< NC line; empty where the file does not tell it

  std::size_t size() const;
  double duration() const { return static_cast<double>(size() - 1) * period; }
  void append(const Setpoints& chunk);
};

/// An axis between its setpoints: a cubic through the four around, so that nothing depends on where samples fall.
struct CommandedPoint {
  double position, speed;  ///< [mm or rad, s]
};
/// @param time  [s]
CommandedPoint commanded_at(const std::vector<double>& position, double period, double time);

/// Reads a setpoint file of any format. @param period  [s] of files that have no times
/// Errors: of open_setpoint_file(); input: setpoints-empty; setpoints-time where its times are no multiples of a period.
Result<CommandedRows> read_commanded(const std::filesystem::path& file, double period, const Monitor& monitor = {});

}  // namespace toolpace
