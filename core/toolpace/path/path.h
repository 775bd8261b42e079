#pragma once
/// The geometry of a program: a chain of segments with exact arc length, as flat arrays.
///
/// Path length is measured in mm along XYZ; on segments where only A, B, C move, in degrees, so that a path limit of
/// 100 mm/s reads as 100 deg/s there, as controllers do it.

#include <cstdint>
#include <vector>

#include "toolpace/base/axes.h"
#include "toolpace/nc/moves.h"

namespace toolpace {

enum class SegmentKind : std::uint8_t { line, arc, spline, blend };

struct Path {
  // One entry a segment.
  std::vector<SegmentKind> kind;
  std::vector<double> length;         ///< > 0
  std::vector<std::uint32_t> move;    ///< row of Moves that it comes from
  std::vector<std::uint32_t> detail;  ///< index into arcs, splines or blends; kNoDetail for lines
  std::vector<AxisVector> node;       ///< size() + 1 points where segments meet [mm, rad]

  struct Arc {
    Eigen::Vector3d centre, radial, lateral, normal;  ///< point = centre + r(φ)(cosφ·radial + sinφ·lateral) + rise·φ/sweep·normal
    double start_radius, end_radius;                  ///< [mm]
    double sweep;                                     ///< [rad], > 0 (lateral is turned so)
    double rise;                                      ///< [mm] along the normal
  };
  std::vector<Arc> arcs;
  // splines and blends: path/spline.h, path/blend.h (added by those features)

  /// Where the machine must stand still: node index -> pause. Sorted by node; the first and last node always rest.
  struct Pause {
    std::size_t node;
    double duration;     ///< [s] ≥ 0, dwell or tool change
    std::uint32_t move;  ///< row of Moves that asks for it
  };
  std::vector<Pause> pauses;

  std::size_t size() const { return kind.size(); }
};

}  // namespace toolpace
