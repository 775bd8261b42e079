#pragma once
/// Where the preview draws its lines: depends on the path alone, so all plans along one path share it.

#include <memory>
#include <vector>

#include "drawing/lod.h"
#include "drawing/projection.h"
#include "toolpace/pipeline/job.h"

namespace toolpace::ui {

enum class PieceStyle : std::uint8_t { feed, rapid };

struct SceneGeometry {
  std::shared_ptr<const Path> path;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< [mm], vertices are relative to it
  Box box;                                           ///< [mm], of all vertices
  Box feed_box;  ///< [mm], of those at which a feed begins or ends; empty without feeds
  SceneLine line;
  LodPyramid lod;

  // Curves are cut into chords.
  std::vector<std::uint32_t> block;  ///< segment of the path, one a piece; empty = piece i is segment i
  std::vector<float> share;          ///< of the segment's length at a piece's end, one a piece; empty = 1 everywhere
  /// [s] one a vertex: only where a motion leaves its path (MotionPlan::splines) and the vertices are of that motion.
  std::vector<double> time;

  bool is_empty() const { return line.vertex.empty(); }
  std::size_t block_of(std::size_t piece) const { return block.empty() ? piece : block[piece]; }
  double share_after(std::size_t piece) const { return share.empty() ? 1.0 : static_cast<double>(share[piece]); }
  double share_before(std::size_t piece) const {
    return !share.empty() && piece > 0 && block[piece - 1] == block[piece] ? share_after(piece - 1) : 0.0;
  }
  /// [mm], of vertex i.
  Eigen::Vector3d point(std::size_t i) const { return centre + line.vertex[i].cast<double>(); }
};

/// Whether the geometry made for another plan serves this one.
bool fits(const SceneGeometry& geometry, const Outcome& outcome);

/// Pure and without a window: call it on the worker. An outcome without a path gives an empty one.
std::shared_ptr<const SceneGeometry> make_scene_geometry(const Outcome& outcome);

}  // namespace toolpace::ui
