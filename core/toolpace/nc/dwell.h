#pragma once
/// How long a program may wait.

namespace toolpace::nc {

inline constexpr double kLongestDwell = 1e9;  ///< [s] some thirty years

/// False for negative times, too.
inline bool is_dwell(double seconds) { return seconds >= 0.0 && seconds <= kLongestDwell; }

}  // namespace toolpace::nc
