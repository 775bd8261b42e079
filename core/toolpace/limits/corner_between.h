#pragma once
/// Which corner rule holds at a node.

#include "toolpace/limits/corner_rule.h"
#include "toolpace/nc/moves.h"

namespace toolpace {

/// The corner rule between two segments: that of the job, unless the program's path control on either side says otherwise.
CornerOptions corner_between(const CornerOptions& job, PathControl before, PathControl after);

}  // namespace toolpace
