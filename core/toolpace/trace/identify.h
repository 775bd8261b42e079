#pragma once
/// The drives of a machine, from a trace.

#include "toolpace/servo/identify_axis.h"
#include "toolpace/servo/servo_simulation.h"
#include "toolpace/trace/align.h"

namespace toolpace {

struct Identification {
  Alignment alignment;
  std::array<std::optional<AxisIdentification>, kAxisCount> axis;
  std::array<std::optional<Error>, kAxisCount> refused;  ///< axes that move and could not be identified, and why
  bool is_same_clock = false;  ///< nothing was known of the clocks, and one clock explains the trace
};

/// Rows of setpoints that are looked at, from the trace's begin on: more make it slow and no better.
inline constexpr std::size_t kMostIdentifiedRows = 60'000;

/// @param known  drives of the machine, for what the trace does not tell
/// Errors: of align() and check_saturation(); that of the first axis where none could be identified; cancelled.
Result<Identification> identify(const CommandedRows& commanded, const Trace& trace, const ServoMachine& known,
                                const Monitor& monitor = {});

}  // namespace toolpace
