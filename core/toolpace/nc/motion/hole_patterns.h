#pragma once
/// Holes on a circle, an arc or a line about or from where the tool stands: G70, G71 and G72 of Haas.

#include "toolpace/nc/context.h"

namespace toolpace::nc {

bool run_hole_pattern(Context& context, const Block& block, Code code);

}  // namespace toolpace::nc
