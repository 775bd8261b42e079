#pragma once
/// Circular pockets about where the tool stands: G12 clockwise, G13 counter-clockwise (Haas, Yasnac, Mach3).

#include "toolpace/nc/context.h"

namespace toolpace::nc {

/// I: radius, of the first circle where K is the last one's and Q the step; Z: depth, under G91 of each of L passes;
/// D: the tool whose radius is taken off.
bool mill_circular_pocket(Context& context, const Block& block, Code code);

}  // namespace toolpace::nc
