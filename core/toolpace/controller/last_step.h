#pragma once
/// How long the last step of a motion takes.

#include "toolpace/controller/window_planner.h"

namespace toolpace::detail::controller {

/// Steppers run in segments of 10 ms, each of whole steps at a steady rate.
///
/// @param steps  of the axis that makes the most of them
/// @return how long the last one takes [s]: a part of that is left over when it was made
/// @source grbl 1.1, stepper.c, st_prep_buffer()
double time_of_last_step(const LastBlock& last, double steps);

}  // namespace toolpace::detail::controller
