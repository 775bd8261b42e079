#pragma once
/// Figures of a planned motion, measured at its setpoints.

#include "drawing/scene_colours.h"

namespace toolpace::ui {

/// The largest contour errors [mm] while the tool cuts, and in rapids, where nobody minds; 0 where there are none.
struct ContourErrors {
  double cutting = 0, rapid = 0;
};

/// @param trace  of the outcome's motion
ContourErrors contour_errors(const Outcome& outcome, const ErrorTrace& trace);

/// Largest distance between the planned motion and the straight lines between its setpoints [mm, deg], wherever it was led by
/// rounded corners: at the corners of the path and in the middle between two setpoints (exact to the fourth power of their
/// distance).
double chord_error(const Outcome& outcome, const Monitor& monitor = {});

}  // namespace toolpace::ui
