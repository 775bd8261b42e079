#pragma once
/// Codes that hold for their block alone: G10, G27 to G30, G52, G92 and its kin, pockets and patterns of holes.

#include "toolpace/nc/context.h"

namespace toolpace::nc {

bool run_once_code(Context& context, const Block& block);

}  // namespace toolpace::nc
