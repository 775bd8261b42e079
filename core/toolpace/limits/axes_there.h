#pragma once
/// Does a program move axes that the machine has not?

#include "toolpace/base/result.h"
#include "toolpace/limits/machine.h"
#include "toolpace/nc/moves.h"
#include "toolpace/path/path.h"

namespace toolpace {

/// One warning "axis-not-there" for each axis that moves, at the first line that moves it, of a machine that says nothing of
/// this axis and something of another.
Diagnostics check_axes(const Path& path, const Moves& moves, const Machine& machine);

}  // namespace toolpace
