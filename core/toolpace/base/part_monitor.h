#pragma once
/// Progress of work in parts.

#include "toolpace/base/monitor.h"

namespace toolpace {

/// The monitor of a part of the work: what that reports as 0 … 1 is from … to of the whole.
inline Monitor part_of(const Monitor& whole, double from, double to) {
  if (!whole.progress) return whole;
  return {whole.stop,
          [progress = whole.progress, from, to](double fraction) { progress(from + (to - from) * fraction); }};
}

}  // namespace toolpace
