#pragma once
/// Setpoint files: one interface over the formats, fed chunk by chunk in bounded memory.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"
#include "toolpace/io/setpoint_format.h"
#include "toolpace/kinematics/chain.h"
#include "toolpace/sample/setpoints.h"
#include "toolpace/verify/setpoint_file.h"

namespace toolpace {

struct SetpointFileOptions {
  const SetpointFormat* format = nullptr;  ///< null = by the name, see format_of()
  bool axis_derivatives = false;           ///< add v, a, j of each axis by differences (not in halstream)
  bool decimal_comma = false;              ///< semicolon only
  std::optional<Chain> tip_of =
      {};  ///< add where that chain has the tip (setpoint_table.h), in formats that name their columns
  std::string program_name = {};  ///< stands in the "meta" of .npz
};

/// Takes setpoints in order and makes a file of them. The file appears at finish(), whole; a writer that dies before it
/// (cancelled, failed) leaves nothing behind and an old file as it was.
class SetpointWriter {
 public:
  virtual ~SetpointWriter() = default;
  SetpointWriter(const SetpointWriter&) = delete;
  SetpointWriter& operator=(const SetpointWriter&) = delete;

  /// Appends a chunk. Chunks follow on (first_row) and have the same axes and period.
  /// Errors: input (see SetpointTable::load), io.
  virtual Result<void> write(const Setpoints& chunk) = 0;

  /// Says of which plan the setpoints are, for formats that keep it (.npz); before finish().
  void tell_origin(SetpointOrigin origin) { origin_ = std::move(origin); }

  /// Completes the file and puts it in place. To be called once, as the last call. Errors: io.
  virtual Result<void> finish() = 0;

 protected:
  SetpointWriter() = default;
  SetpointOrigin origin_;
};

/// @param monitor  its stop token ends waits for the reader of a pipe
/// Errors: usage (setpoint-format-unknown, setpoint-columns-unnamed), io, cancelled.
Result<std::unique_ptr<SetpointWriter>> open_setpoint_writer(const std::filesystem::path& file,
                                                             const SetpointFileOptions& options = {},
                                                             const Monitor& monitor = {});

}  // namespace toolpace
