#pragma once
/// A path as a stream of vertices: lines by their ends, curves by chords that stay close to them.

#include <cstdint>
#include <vector>

#include "toolpace/path/path.h"

namespace toolpace {

/// A point with rotary axes in degrees, so that 1 mm and 1 deg weigh the same, as path length does it.
AxisVector weighted(const AxisVector& point);

struct PathVertex {
  AxisVector point;       ///< weighted
  std::uint32_t segment;  ///< the one that ends here or goes through here
  double s;               ///< path length from the segment's start
  bool is_node;           ///< end of its segment
  double sagitta;         ///< [mm] how far the chord that ends here may be from the path; 0 on lines
};

/// Vertices are made when asked for and forgotten when passed, so memory is bounded by the stretch in use.
class PathVertices {
 public:
  /// @param sagitta  [mm] > 0, how far a chord may be from its curve
  PathVertices(const Path& path, double sagitta);

  /// Vertex of this index, or null beyond the end of the path. Indices below the last forget_before() are gone.
  /// The pointer holds until the next call.
  const PathVertex* at(std::size_t index);
  void forget_before(std::size_t index);
  /// Replaces the place t on chord `cell` (from vertex cell to cell + 1) and its distance from the point by the nearest
  /// place of the curve itself from there on.
  void measure(std::size_t cell, double& t, double& distance, const AxisVector& point);

 private:
  bool make_next();

  const Path& path_;
  double sagitta_;
  std::vector<PathVertex> vertices_;
  std::size_t first_ = 0;  ///< index of vertices_.front()
  std::size_t segment_ = 0;
  std::size_t chord_ = 0, chords_ = 0;  ///< of the segment; chords_ = 0: not begun
};

}  // namespace toolpace
