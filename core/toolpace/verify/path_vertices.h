#pragma once
/// A path as a stream of vertices: lines by their ends, arcs by sectors, other curves by chords that stay close to them.

#include <cstdint>
#include <limits>
#include <vector>

#include "toolpace/path/path.h"
#include "toolpace/verify/arc_sector.h"

namespace toolpace {

/// That bring the nearest place of a curve from a chord within 1e-5 mm of it to rounding.
inline constexpr int kNewtonSteps = 4;

/// A setpoint this close to the path is on it: what exact geometry and rounding leave [mm].
inline constexpr double kOnPath = 1e-6;

/// A point with rotary axes in degrees, so that 1 mm and 1 deg weigh the same, as path length does it.
AxisVector weighted(const AxisVector& point);

struct PathVertex {
  static constexpr std::uint32_t kNoSector = 0xffffffff;

  AxisVector point;       ///< weighted
  std::uint32_t segment;  ///< the one that ends here or goes through here
  std::uint32_t sector;   ///< of the arc that leads here, see PathVertices::sector()
  double s;               ///< path length from the segment's start, of chords
  bool is_node;           ///< end of its segment
  double sagitta;         ///< [mm] how far the chord that ends here may be from the path; 0 on lines and sectors
};

/// What is asked of one segment.
struct SegmentRule {
  double tolerance = std::numeric_limits<double>::infinity();  ///< [mm]
  bool is_exact =
      false;  ///< nothing smooths its ends, however near a blend may lie beside them (G61, G61.1, the job's rule)
};

/// Cell j leads from vertex j to vertex j + 1. Vertices are made when asked for and forgotten when passed, so memory is
/// bounded by the stretch in use.
class PathVertices {
 public:
  /// @param sagitta  [mm] > 0, how far a chord may be from its curve
  /// @param rules    of each segment; empty = the default for all
  PathVertices(const Path& path, double sagitta, std::vector<SegmentRule> rules = {});

  /// Vertex of this index, or null beyond the end of the path. Indices below the last forget_before() are gone.
  /// The pointer holds until the next call.
  const PathVertex* at(std::size_t index);
  void forget_before(std::size_t index);

  /// The sector that leads to a vertex, or null for lines and chords.
  const ArcSector* sector(const PathVertex& end) const {
    return end.sector == PathVertex::kNoSector ? nullptr : &sectors_[end.sector - first_sector_];
  }
  /// Of the segment that a vertex ends or belongs to.
  SegmentRule rule(const PathVertex& end) const { return rule(end.segment); }
  SegmentRule rule(std::size_t segment) const { return rules_.empty() ? SegmentRule{} : rules_[segment]; }

  /// Point at the share t 0 … 1 of a cell that there is (weighted).
  AxisVector point(std::size_t cell, double t);
  /// Replaces the place t on a chord (from vertex cell to cell + 1) and its distance from the point by the nearest
  /// place of the curve itself from there on.
  void measure(std::size_t cell, double& t, double& distance, const AxisVector& point);

 private:
  bool make_next();
  bool has_sectors(std::size_t segment) const;

  const Path& path_;
  double sagitta_;
  std::vector<SegmentRule> rules_;
  std::vector<PathVertex> vertices_;
  std::vector<ArcSector> sectors_;
  std::size_t first_ = 0;         ///< index of vertices_.front()
  std::size_t first_sector_ = 0;  ///< index of sectors_.front()
  std::size_t segment_ = 0;
  std::size_t part_ = 0, parts_ = 0;  ///< of the segment; parts_ = 0: not begun
};

}  // namespace toolpace
