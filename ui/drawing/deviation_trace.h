#pragma once
/// How far one path runs from another, place by place, to be drawn enlarged.

#include <memory>

#include "drawing/scene_colours.h"
#include "toolpace/base/monitor.h"
#include "toolpace/path/path.h"

namespace toolpace::ui {

/// Follows `path` with points of `other`, in order, so that strokes that cross or pass close by do not count. Its times count points.
/// Null where the paths are farther apart than the tolerance, and when cancelled. Call it on the worker.
/// @param tolerance  [mm] > 0
std::shared_ptr<const ErrorTrace> make_deviation_trace(const Path& path, const Path& other, double tolerance,
                                                       const Monitor& monitor = {});

}  // namespace toolpace::ui
