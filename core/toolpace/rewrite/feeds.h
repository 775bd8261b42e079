#pragma once
/// Feeds that a controller can hold, though it does not know the machine's limits on curves, or gets its blocks late.

#include <vector>

#include "toolpace/limits/machine.h"
#include "toolpace/nc/reading.h"
#include "toolpace/rewrite/write_run.h"

namespace toolpace {

struct FeedLimits {
  Machine machine;          ///< speeds and accelerations of X, Y, Z; those along the path where axes have none
  double block_time = 0.0;  ///< [s] that a block takes to come and to be read, ≥ 0
};

namespace detail::rewrite {

/// Lowers the feeds of spans to what keeps every axis within its speed and, on arcs, within its acceleration across the path, and
/// lets no block be over before the next one is there. Never above the program's. Neighbours share a feed as long as that takes at
/// most 1 % longer than each at its own.
void plan_feeds(const Reading& reading, const FeedLimits& limits, std::vector<Edit>& edits);

}  // namespace detail::rewrite
}  // namespace toolpace
