#pragma once
/// Where in the band a resonance may be that a drive's trace shows.

#include <vector>

#include "toolpace/servo/servo_fit.h"

namespace toolpace::detail {

inline constexpr double kLeastFrequency = 2.0;    ///< [Hz] that is looked at
inline constexpr double kLookedAtDamping = 0.05;  ///< of a mode that is not known yet

/// Frequencies at which a mode would explain most of what a drive leaves of the trace, beside all that its own values could; the
/// best first, three at most. [Hz]
std::vector<double> resonance_frequencies(const ServoFit& fit, const FitState& from);

}  // namespace toolpace::detail
