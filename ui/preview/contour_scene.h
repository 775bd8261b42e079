#pragma once
/// What the contour preview draws: the path as a coloured polyline, ready made on the worker thread.

#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "preview/lod.h"
#include "preview/phase_bounds.h"
#include "preview/projection.h"
#include "toolpace/pipeline/job.h"

namespace toolpace::ui {

enum class ColourBy : std::uint8_t { speed, acceleration, jerk, limit, contour_error };

enum class PieceStyle : std::uint8_t { feed, rapid };

/// Where the tool really went, as a drive simulation found it.
struct ErrorTrace {
  std::vector<double> time;                ///< [s], ascending
  std::vector<float> error;                ///< contour error [mm], ≥ 0
  std::vector<Eigen::Vector3f> commanded;  ///< where it was asked to be [mm]
  std::vector<Eigen::Vector3f> offset;     ///< actual minus commanded position at that time [mm]
};

struct ContourScene {
  std::shared_ptr<const Outcome> outcome;
  std::shared_ptr<const ErrorTrace> trace;           ///< null = not simulated
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< [mm], vertices are relative to it
  Box box;                                           ///< [mm], of all vertices
  std::optional<Box> travel;                         ///< [mm], only where X, Y and Z are all bounded

  ColouredLine line;
  std::vector<double> time;                      ///< [s] one a vertex; rises
  std::vector<std::uint32_t> block;              ///< segment of the path, one a piece
  std::array<Interval, kColourings> range = {};  ///< value at level 0 and at level 255 [mm, s]
  LodPyramid lod;

  bool is_empty() const { return line.vertex.empty(); }
  bool can_colour_by(ColourBy by) const { return !line.level[static_cast<std::size_t>(by)].empty(); }
  /// [mm], of vertex i.
  Eigen::Vector3d point(std::size_t i) const { return centre + line.vertex[i].cast<double>(); }
};

/// Pure and without a window: call it on the worker. Lines and curves are cut where the motion changes, so that colours
/// follow the plan inside long blocks too; blocks much smaller than a pixel of the whole view keep their mean.
/// An outcome without a plan (empty node_time) is drawn without colours.
std::shared_ptr<const ContourScene> make_contour_scene(std::shared_ptr<const Outcome> outcome,
                                                       std::shared_ptr<const ErrorTrace> trace = nullptr);

/// A place on the path.
struct PathPlace {
  std::size_t block = 0;                            ///< segment of the path
  double along = 0;                                 ///< [mm] from its start
  double time = 0;                                  ///< [s]
  PhaseState state = {};                            ///< exact, along the path
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< [mm]
  std::uint32_t line = 0;                           ///< NC line, 0 = unknown
};

/// Where the tool is at a time of the plan, exactly; clamped to the plan. Nothing for an outcome without a plan.
std::optional<PathPlace> place_at(const Outcome& outcome, double time);

/// What holds the speed down at a time; nothing where the outcome does not say.
std::optional<Cause> cause_at(const Outcome& outcome, double time);

/// First and last moment of an NC line of the main program [s]; nothing where the line does not move. Of the passes of a
/// loop the one at `time` is meant, or the first if it is none of them.
std::optional<std::pair<double, double>> time_of_line(const Outcome& outcome, std::uint32_t line, double time = 0.0);

}  // namespace toolpace::ui
