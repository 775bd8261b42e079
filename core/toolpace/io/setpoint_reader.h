#pragma once
/// Setpoint files, opened by what they are.

#include "toolpace/base/monitor.h"
#include "toolpace/verify/setpoint_file.h"

namespace toolpace {

/// Opens a file of any of setpoint_formats(): what it is shows in its first bytes, text of one kind or another by the name.
/// "-" = standard input. Errors: io; cancelled; input: setpoints-empty, setpoints-header, setpoints-shape, setpoints-broken.
/// @param monitor  its stop token ends waits of this and the later calls
Result<std::unique_ptr<SetpointFile>> open_setpoint_file(const std::filesystem::path& file,
                                                         const Monitor& monitor = {});

}  // namespace toolpace
