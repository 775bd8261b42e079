#pragma once
/// Motion that hangs on the spindle: G33 threads, G33.1 rigid tapping, G76 threading cycles.

#include "toolpace/nc/context.h"

namespace toolpace::nc {

bool run_synchronised(Context& context, const Block& block);
bool run_rigid_tap(Context& context, const Block& block);
bool run_threading(Context& context, const Block& block);

}  // namespace toolpace::nc
