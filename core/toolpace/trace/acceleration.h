#pragma once
/// What an accelerometer recorded: a table of times and accelerations.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"

namespace toolpace {

struct AccelerationRecord {
  std::string name;
  double period = 0;                             ///< [s] from row to row, evenly
  std::array<std::vector<double>, 3> axis = {};  ///< X, Y, Z [mm/s²]; empty where the file has none
  std::array<std::string, 3> column = {};        ///< their names
  std::array<std::string, 3> unit = {};          ///< as the file has it; empty where nothing tells it: then as mm/s²

  std::size_t rows() const;
};

struct AccelerationOptions {
  std::string columns =
      {};  ///< "t=1,x=accel_x[g]"; empty = by their names, or t, x, y, z in order where there are none
  std::optional<double> step = {};  ///< [s] from row to row where no column tells the time
};

/// Klipper's raw format (#time,accel_x,accel_y,accel_z), and any other table as TraceFile reads it, in g, mg, m/s² or mm/s². Steps that
/// scatter by less than half of one are made even, by straight lines between rows.
/// Errors: of read_trace(); usage and input: accelerometer-columns; input: accelerometer-short, accelerometer-uneven.
Result<AccelerationRecord> read_acceleration(const std::filesystem::path& file, const AccelerationOptions& options,
                                             const Monitor& monitor = {});

}  // namespace toolpace
