#pragma once
/// How wrong the frequency of a mode may be for its shaper.

#include "toolpace/sample/shaper.h"

namespace toolpace {

/// Shares of the frequency, around 1, between which less of a mode's vibration is left than `most`; both 1 where even the frequency
/// itself leaves more. Looked for down to 0 and up to 3; to 1e-9.
struct ShaperBand {
  double low = 1, high = 1;
};
ShaperBand shaper_band(const Impulses& impulses, double frequency, double damping, double most);

}  // namespace toolpace
