#pragma once
/// Probing: G38.2 to G38.5, and what skips to a signal elsewhere.

#include "toolpace/nc/context.h"

namespace toolpace::nc {

bool run_probe(Context& context, const Block& block, Code code);

}  // namespace toolpace::nc
