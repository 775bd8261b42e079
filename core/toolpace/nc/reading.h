#pragma once
/// What was understood of a program, for all that work on it; reading itself stands in reader.h.

#include <string>
#include <vector>

#include "toolpace/base/result.h"
#include "toolpace/nc/dialect.h"
#include "toolpace/nc/modal_log.h"
#include "toolpace/nc/moves.h"

namespace toolpace {

/// What was understood. `refused` = at least one error: `moves` then holds the motion up to the first one.
struct Reading {
  Moves moves;
  Diagnostics diagnostics;
  ModalLog modal;                            ///< what was modal at which line; empty for polylines
  Dialect dialect = Dialect::linuxcnc;       ///< the dialect it was read in
  std::vector<std::string> dialect_reasons;  ///< why; empty where the dialect was given
  bool refused = false;
};

}  // namespace toolpace
