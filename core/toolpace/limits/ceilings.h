#pragma once
/// A machine under what a program lowers its limits to (MotionCeiling): never above the machine's own.

#include <vector>

#include "toolpace/limits/machine.h"
#include "toolpace/path/commanded.h"

namespace toolpace {

/// Speeds and accelerations of axes and path, the lower ones of both.
Machine under(const Machine& machine, const MotionCeiling& ceiling);

/// One for each of the commands' ceilings.
std::vector<Machine> machines_under(const Machine& machine, const Commands& commands);

/// What segments begin … end − 1 keep wherever they do, and what none of them exceeds.
MotionCeiling lowest_ceiling(const Commands& commands, std::size_t begin, std::size_t end);
MotionCeiling highest_ceiling(const Commands& commands, std::size_t begin, std::size_t end);

/// What no motion of the program exceeds.
MotionCeiling highest_ceiling(const Moves& moves);

/// Whether the segments have different ceilings.
bool has_mixed_ceilings(const Commands& commands, std::size_t begin, std::size_t end);

}  // namespace toolpace
