#pragma once
/// Canned cycles G73, G74, G81 … G89 in every plane.

#include "toolpace/nc/context.h"

namespace toolpace::nc {

bool run_cycle(Context& context, const Block& block, Code code);

}  // namespace toolpace::nc
