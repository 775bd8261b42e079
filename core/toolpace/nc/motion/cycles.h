#pragma once
/// Canned cycles G73, G74, G76, G81 … G89 in every plane.

#include <vector>

#include "toolpace/nc/context.h"

namespace toolpace::nc {

bool run_cycle(Context& context, const Block& block, Code code);

/// Runs the cycle that is on, with the words it has, at each of the places.
bool run_cycle_at(Context& context, Code code, const std::vector<Position>& places);

}  // namespace toolpace::nc
