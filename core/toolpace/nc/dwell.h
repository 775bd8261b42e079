#pragma once
/// How long a program waits, and may wait.

#include "toolpace/nc/context.h"

namespace toolpace::nc {

inline constexpr double kLongestDwell = 1e9;  ///< [s] some thirty years

/// False for negative times, too.
inline bool is_dwell(double seconds) { return seconds >= 0.0 && seconds <= kLongestDwell; }

/// P in s: as the dialect counts it.
double dwell_of(Context& context, const Block& block);

}  // namespace toolpace::nc
