#pragma once
/// The readers of setpoint files, for the table of formats (io/setpoint_format.h).

#include <memory>
#include <string>

#include "toolpace/base/input_file.h"
#include "toolpace/verify/setpoint_file.h"

namespace toolpace::detail {

/// Comma or semicolon, decimal point or comma: by its header.
Result<std::unique_ptr<SetpointFile>> open_text(InputFile file, const std::string& name);
Result<std::unique_ptr<SetpointFile>> open_halstream(InputFile file, const std::string& name);
Result<std::unique_ptr<SetpointFile>> open_npy(InputFile file, const std::string& name);
Result<std::unique_ptr<SetpointFile>> open_npz(InputFile file, const std::string& name);

Error setpoints_error(const char* code, std::string message, Location where, std::string remedy = "");

}  // namespace toolpace::detail
