#pragma once
/// Whether two rows of two programs say the same.

#include <cstddef>

#include "toolpace/nc/moves.h"

namespace toolpace::detail::rewrite {

/// To the bit, and in the same file; whatever their lines.
bool same_row(const Moves& a, std::size_t i, const Moves& b, std::size_t j);

}  // namespace toolpace::detail::rewrite
