#pragma once
/// A time that no motion through the tolerance tube can beat.

#include "toolpace/limits/machine.h"
#include "toolpace/path/commanded.h"

namespace toolpace {

/// Lower bound of the time of any motion that stays in order within a tolerance of the programmed path, rests where the
/// path has its pauses, and keeps feeds and the limits of speed and acceleration [s]; pauses are not in it.
///
/// Such a motion comes within the tolerance r of any chosen points of the path, so between two of them, d apart, it
/// travels at least d − 2r, and along each axis at least |Δ| − 2r. The time is then at least that of these lengths at top
/// speed, and, as a shorter way from rest to rest takes no longer, at least that of the fastest motion along a line that
/// consists of them. Points 25, 100 and 400 times r apart are tried, and those whose times at top speed add up to the most; the
/// largest time counts. Weak where the path has
/// sharp corners that the machine must slow down for; jerk and rotary axes are not looked at.
///
/// @param path  as programmed, before corners were rounded
/// @param tolerance  largest distance from the path [mm] ≥ 0, of the job and any G64 P in the program
double tube_bound(const Path& path, const Commands& commands, const Machine& machine, double tolerance);

}  // namespace toolpace
