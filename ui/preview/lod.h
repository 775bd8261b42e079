#pragma once
/// Level-of-detail pyramid over a coloured polyline: fewer and fewer vertices, each level with a proven distance.
///
/// Piece i of a polyline joins vertex i to vertex i + 1. A level keeps some vertices; the polyline through them lies
/// within `tolerance` of the full one, so a view whose pixels are at least that large loses nothing that it could show.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace toolpace::ui {

inline constexpr std::size_t kColourings = 5;

/// A polyline with a colour level (0 … 255) a piece for each way of colouring, and a style a piece.
struct ColouredLine {
  std::vector<Eigen::Vector3f> vertex;                       ///< [mm] relative to a centre kept elsewhere
  std::vector<std::uint8_t> style;                           ///< pieces; pieces of unequal style are never merged
  std::array<std::vector<std::uint8_t>, kColourings> level;  ///< pieces each, or empty where not available
  std::size_t categorical = kColourings;                     ///< which colouring names categories, not quantities

  std::size_t pieces() const { return style.size(); }
};

/// Box around a run of pieces.
struct ChunkBox {
  Eigen::Vector3f low, high;
};

inline constexpr std::size_t kChunk = 256;  ///< pieces a box

/// One level. Piece j joins vertex[j] to vertex[j + 1] of the full line.
struct LodLevel {
  float tolerance = 0;                                       ///< [mm]
  std::vector<std::uint32_t> vertex;                         ///< kept vertices, ascending; empty = all (the full line)
  std::array<std::vector<std::uint8_t>, kColourings> level;  ///< mean by length; most length for categories
  std::vector<ChunkBox> boxes;                               ///< one a chunk of pieces

  bool is_full() const { return vertex.empty(); }
};

/// Levels from the full line on, tolerances rising. A level that would not save a third of its vertices is left out.
struct LodPyramid {
  std::vector<LodLevel> levels;

  /// Coarsest level whose tolerance is at most `tolerance` [mm]; the full line if none.
  std::size_t level_for(double tolerance) const;
};

/// Builds the levels between `finest` and `coarsest` tolerance [mm, > 0], a factor 2 apart. Linear in the vertices.
LodPyramid build_lod(const ColouredLine& line, double finest, double coarsest);

}  // namespace toolpace::ui
