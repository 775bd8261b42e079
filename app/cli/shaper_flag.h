#pragma once
/// --shaper, for commands that make setpoints.

#include <string>

#include "command_line.h"
#include "json.h"
#include "toolpace/machine/setup.h"
#include "toolpace/pipeline/job.h"

namespace toolpace::cli {

struct ShaperFlag {
  std::string name;  ///< empty if not given

  void add_to(Command& command);
  /// Usage errors: bad-flag; shaper-no-resonance where the machine has nothing to be shaped for.
  Result<void> apply_to(Setup& setup) const;
};

/// What a shaper adds to the JSON of an outcome: itself, and the time that it takes; null without one.
void add_shaper(Json& json, const Outcome& outcome);

}  // namespace toolpace::cli
