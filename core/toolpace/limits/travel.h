#pragma once
/// Does a program leave the machine's travel?

#include "toolpace/base/result.h"
#include "toolpace/limits/machine.h"
#include "toolpace/nc/moves.h"
#include "toolpace/path/path.h"

namespace toolpace {

/// One warning "travel" for each axis and side that is left, at the first line that does it, with the worst excess.
/// Lines and arcs exactly, splines by their control polygon's piece ends and middle.
Diagnostics check_travel(const Path& path, const Moves& moves, const Machine& machine);

}  // namespace toolpace
