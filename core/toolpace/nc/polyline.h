#pragma once
/// CSV polylines: header x_mm,y_mm,z_mm,feed_mm_min (any order, fewer columns; a, b, c in deg), a row a point.

#include <string>
#include <string_view>

#include "toolpace/base/monitor.h"
#include "toolpace/nc/read_options.h"
#include "toolpace/nc/reading.h"

namespace toolpace::nc {

/// The first row is the start; the feed of a row is that of the move which ends there. Without a feed column the feed is
/// infinite: as fast as the machine allows.
/// @return false if it was cancelled
bool read_polyline(std::string_view text, const std::string& name, const ReadOptions& options, const Monitor& monitor,
                   Reading& reading);

}  // namespace toolpace::nc
