#pragma once
/// What the motion plots draw of the visible time, between the files of ProfilePlot.

#include "plots/profile_plot.h"

namespace toolpace::ui {

/// What is drawn of the visible time.
struct ProfilePlot::Curves {
  MotionCurves own;
  MotionEnvelope other;
  std::array<MotionCurves, kPlottedAxes> axes;
  Curve error, measured;
  SwingRow::Curves follow, swing;
};

}  // namespace toolpace::ui
