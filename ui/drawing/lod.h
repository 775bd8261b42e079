#pragma once
/// Level-of-detail pyramid over a polyline: fewer and fewer vertices, each level with a proven distance.
///
/// Piece i of a polyline joins vertex i to vertex i + 1. A level keeps some vertices; the polyline through them lies
/// within `tolerance` of the full one, so a view whose pixels are at least that large loses nothing that it could show.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace toolpace::ui {

/// A polyline with a style a piece.
struct SceneLine {
  std::vector<Eigen::Vector3f> vertex;  ///< [mm] relative to a centre kept elsewhere
  std::vector<std::uint8_t> style;      ///< pieces; pieces of unequal style are never merged

  std::size_t pieces() const { return style.size(); }
};

/// Box around a run of pieces.
struct ChunkBox {
  Eigen::Vector3f low, high;
};

inline constexpr std::size_t kChunk = 256;  ///< pieces a box

/// One level. Piece j joins vertex[j] to vertex[j + 1] of the full line.
struct LodLevel {
  float tolerance = 0;                ///< [mm]
  std::vector<std::uint32_t> vertex;  ///< kept vertices, ascending; empty = all (the full line)
  std::vector<ChunkBox> boxes;        ///< one a chunk of pieces

  bool is_full() const { return vertex.empty(); }
  /// Vertex of the full line that piece j begins at.
  std::size_t at(std::size_t j) const { return is_full() ? j : vertex[j]; }
};

/// Levels from the full line on, tolerances rising. A level that would not save a third of its vertices is left out.
struct LodPyramid {
  std::vector<LodLevel> levels;

  /// Coarsest level whose tolerance is at most `tolerance` [mm]; the full line if none.
  std::size_t level_for(double tolerance) const;
};

/// Builds the levels between `finest` and `coarsest` tolerance [mm, > 0], a factor 2 apart. Linear in the vertices.
LodPyramid build_lod(const SceneLine& line, double finest, double coarsest);

/// Shades (0 … 255) of a level's pieces from those of the full line's: means by length, or for categories (0 … 15) the
/// one with most length. Linear in the full line.
std::vector<std::uint8_t> merged_means(const SceneLine& line, const LodLevel& level,
                                       const std::vector<std::uint8_t>& full);
std::vector<std::uint8_t> merged_majorities(const SceneLine& line, const LodLevel& level,
                                            const std::vector<std::uint8_t>& full);

}  // namespace toolpace::ui
