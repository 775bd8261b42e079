#pragma once
/// Whether coordinates without a decimal point are lengths, or counts of least increments.

#include <cstddef>
#include <string_view>

namespace toolpace::nc {

struct IntegerUse {
  bool are_increments = false;
  std::size_t line = 0;  ///< of the first coordinate but 0 that has no point, from 1; 0 = there is none
};

/// Looks at the beginning of `text`. Counts of increments are large, and no coordinate beside them has a point.
IntegerUse look_at_integers(std::string_view text);

}  // namespace toolpace::nc
