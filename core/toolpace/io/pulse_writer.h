#pragma once
/// Pulse tables as files.

#include <cstdint>
#include <filesystem>

#include "toolpace/base/monitor.h"
#include "toolpace/base/result.h"
#include "toolpace/sample/pulse_table.h"

namespace toolpace {

enum class PulseFormat : std::uint8_t {
  csv,      ///< header pulse,ticks; ticks = timer ticks before that pulse
  c_header  ///< a C header with a constant array of uint32_t, the parameters in a comment
};

/// Writes the whole table in bounded memory; the file appears whole or not at all. "-" = standard output.
/// Errors: io, cancelled.
Result<void> write_pulses(const std::filesystem::path& file, const PulseTable& table, PulseFormat format,
                          const Monitor& monitor = {});

}  // namespace toolpace
