#pragma once
/// A command of the command line, run on a thread of its own while the caller stays free to do something else.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "toolpace/pipeline/job.h"
#include "toolpace/sample/pulse_table.h"

namespace toolpace::python {

/// What a command came to.
struct Ran {
  int exit_code = 0;
  bool has_failed = false;  ///< then `json` tells why, as --json does
  std::string json;         ///< empty where the command has none
  std::string told;         ///< what the command line would print to stderr, such as warnings
  std::shared_ptr<const Outcome> plan;
  std::optional<Chain> tip_of;  ///< whose tip its setpoints tell, too
  std::optional<PulseTable> pulses;
};

/// How far a command is; `what` is null before it has said so.
struct Progress {
  const char* what = nullptr;
  double fraction = 0.0;
};

/// Runs `words` to their end.
///
/// @param before  plan from which to plan again, or null
/// @param look    called on the calling thread every 20 ms meanwhile; false stops the command
Ran run_command(const std::vector<std::string>& words, std::shared_ptr<const Outcome> before,
                const std::function<bool(const Progress&)>& look);

/// Does `work` likewise; what it throws is thrown again on the calling thread.
void work_beside(const std::function<void(const Monitor&)>& work, const std::function<bool()>& look);

}  // namespace toolpace::python
