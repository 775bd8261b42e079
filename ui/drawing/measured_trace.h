#pragma once
/// What a scope recorded, laid beside a plan, ready to be drawn.

#include <QString>
#include <array>
#include <memory>
#include <vector>

#include "drawing/scene_colours.h"
#include "toolpace/trace/compare.h"

namespace toolpace::ui {

/// Row k of all columns is the trace's k-th row that falls into the plan.
struct MeasuredTrace {
  QString name;                            ///< of its file
  std::shared_ptr<const Outcome> outcome;  ///< the plan that it was compared with
  Comparison comparison;
  std::shared_ptr<const ErrorTrace> actual;  ///< contour error, and where the machine went
  std::array<std::vector<float>, kAxisCount> following =
      {};  ///< actual minus commanded [mm, rad]; empty where not measured
};

}  // namespace toolpace::ui
