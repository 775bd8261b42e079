#pragma once
/// What the contour preview draws: a path, where its lines run, and how they are coloured.

#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "drawing/scene_colours.h"
#include "toolpace/pipeline/job.h"

namespace toolpace::ui {

/// One plan along one geometry, coloured on demand. Immutable but for what it keeps once it is made.
struct ContourScene {
  std::shared_ptr<const Outcome> outcome;
  std::shared_ptr<const ErrorTrace> trace;  ///< null = not simulated
  std::optional<Box> travel;                ///< [mm], only where X, Y and Z are all bounded
  std::optional<double> tolerance;          ///< [mm] within which all moves may be left; none = not the same for all
  std::shared_ptr<const SceneGeometry> geometry = std::make_shared<SceneGeometry>();
  std::unique_ptr<const SceneColours> colours;  ///< null where there is no plan

  bool is_empty() const { return geometry->is_empty(); }
  bool can_colour_by(ColourBy by) const { return colours && colours->has(by); }
  Interval range(ColourBy by) const { return colours ? colours->range(by) : Interval{0, 0}; }
  Eigen::Vector3d point(std::size_t i) const { return geometry->point(i); }
};

/// Pure and without a window: call it on the worker.
/// @param known  geometry made before; taken over where it fits the outcome's path
/// An outcome without a plan (empty node_time) is drawn without colours.
std::shared_ptr<const ContourScene> make_contour_scene(std::shared_ptr<const Outcome> outcome,
                                                       std::shared_ptr<const ErrorTrace> trace = nullptr,
                                                       std::shared_ptr<const SceneGeometry> known = nullptr);

/// The view to begin with: of programs for lathes theirs, else suited_view().
View opening_view(const ContourScene& scene, View wanted);

/// First and last moment of an NC line of the main program [s]; nothing where the line does not move. Of the passes of a
/// loop the one at `time` is meant, or the first if it is none of them.
std::optional<std::pair<double, double>> time_of_line(const Outcome& outcome, std::uint32_t line, double time = 0.0);

}  // namespace toolpace::ui
