#pragma once
/// Progress and cancellation of long work, in one object that is passed down.

#include <cstddef>
#include <functional>
#include <stop_token>

#include "toolpace/base/result.h"

namespace toolpace {

/// Cheap steps (lines, blocks, nodes) between two looks at a monitor.
inline constexpr std::size_t kReportEvery = 1 << 14;

struct Monitor {
  std::stop_token stop = {};
  std::function<void(double fraction)> progress =
      {};  ///< fraction in [0, 1], never falling; called on the working thread

  bool is_cancelled() const { return stop.stop_requested(); }
  void report(double fraction) const {
    if (progress) progress(fraction);
  }
};

/// The error every stage returns when its monitor was cancelled.
inline Error cancelled_error() { return {ErrorKind::cancelled, "cancelled", "cancelled", "", {}, {}}; }

}  // namespace toolpace
