#pragma once
/// Fanuc's macro calls G65 G66 G67, and the alarms that macros raise.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "toolpace/nc/context.h"
#include "toolpace/nc/flow/flow.h"

namespace toolpace::nc {

class MacroCalls {
 public:
  MacroCalls(Flow& flow, FaultSink& faults) : flow_(flow), faults_(faults) {}

  /// Calls what the block calls, or after motion the macro that is modal.
  bool run(const Block& block);
  bool has_modal() const { return modal_.active; }

 private:
  struct Standing {
    bool active = false;
    std::string program;  ///< its number or name
    std::vector<double> arguments;
    std::optional<std::size_t> running_at;  // depth of calls that it was called from, while it runs
  };

  Flow& flow_;
  FaultSink& faults_;
  Standing modal_;  ///< of G66
};

/// #3000 = n (TEXT) stops the machine with an alarm, #3006 with a message.
bool raise_alarm(Context& context, const Block& block);

}  // namespace toolpace::nc
