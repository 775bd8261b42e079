#pragma once
/// The geometry of a program: a chain of segments with exact arc length, as flat arrays.
///
/// It lies in the workpiece: where a program is about the tool's tip (Path::tellings), X Y Z are the tip's, and what the axes do is
/// told by AxisCurve (axis_curve.h); elsewhere both are the same.
///
/// Path length is measured in mm along XYZ; on segments where only A, B, C move, in degrees, so that a path limit of
/// 100 mm/s reads as 100 deg/s there, as controllers do it.

#include <cstdint>
#include <vector>

#include "toolpace/base/metric.h"
#include "toolpace/kinematics/rotary_turn.h"
#include "toolpace/nc/moves.h"
#include "toolpace/path/arc.h"
#include "toolpace/path/blend.h"
#include "toolpace/path/node_positions.h"
#include "toolpace/path/spline.h"

namespace toolpace {

enum class SegmentKind : std::uint8_t { line, arc, spline, blend };

struct Path {
  // One entry a segment.
  std::vector<SegmentKind> kind;
  std::vector<double> length;         ///< > 0 [mm; deg where only rotary axes move]
  std::vector<std::uint32_t> move;    ///< row of Moves that it comes from, whose feed holds (see handovers)
  std::vector<std::uint32_t> detail;  ///< index into arcs, spline_pieces or blends; kNoDetail for lines
  std::vector<AxisVector> node;       ///< size() + 1 points where segments meet [mm, rad]
  NodePositions position;             ///< of each node: the path that lies before it [mm; deg]

  std::vector<ArcCurve> arcs;
  std::vector<SplineCurve> splines;
  std::vector<SplinePiece> spline_pieces;
  std::vector<CornerBlend> corner_blends;
  std::vector<CurveBlend> curve_blends;  ///< detail = kCurveBlend + index
  static constexpr std::uint32_t kCurveBlend = 0x80000000u;

  /// Of each segment: index into turns, or kNoDetail where the rotary axes turn evenly; empty where they do everywhere.
  std::vector<std::uint32_t> turn;
  std::vector<RotaryTurn> turns;  ///< by path length from a segment's start; of lines and arcs

  /// Where the machine must stand still, sorted by node; several may stand on one node. The ends always rest.
  struct Pause {
    std::uint32_t node;
    std::uint32_t move;  ///< row of Moves that asks for it
    double duration;     ///< [s] ≥ 0: dwell, tool change or 0
  };
  std::vector<Pause> pauses;

  /// A place inside a segment that stands for several moves (merged lines, corner curves), from which on the tool is on
  /// another one than before; sorted along the path.
  struct Handover {
    std::uint32_t segment;
    std::uint32_t move;  ///< row of Moves
    double at;           ///< path length from the segment's start, 0 ≤ at < length
  };
  std::vector<Handover> handovers;

  /// From a node on, at which the machine rests, segments are about the tip of another chain; sorted by node, one a node.
  struct Telling {
    std::uint32_t node;
    Chain chain;        ///< without joints: X Y Z are the axes themselves
    AxisVector before;  ///< the node as it is told before
  };
  std::vector<Telling> tellings;  ///< empty: by the axes all along
  /// Rows of Moves whose rotary axes turn evenly although the tool should turn in a plane: see turn_tool().
  std::vector<std::uint32_t> out_of_plane;

  std::size_t size() const { return kind.size(); }

  /// Where a segment ends, told as the segment is.
  const AxisVector& end_of(std::size_t segment) const {
    return tellings.empty() ? node[segment + 1] : told_end_of(segment);
  }
  const AxisVector& told_end_of(std::size_t segment) const;

  /// How the rotary axes turn on a segment; null: evenly.
  const RotaryTurn* turn_of(std::size_t segment) const {
    return turn.empty() || turn[segment] == kNoDetail ? nullptr : &turns[turn[segment]];
  }

  /// About whose tip a segment is; null: about none, X Y Z are the axes themselves.
  const Chain* chain_of(std::size_t segment) const { return tellings.empty() ? nullptr : told_chain_of(segment); }
  const Chain* told_chain_of(std::size_t segment) const;
};

/// A point of a segment and its derivatives by path length, in axis units (mm or rad) per path unit.
struct Frame {
  AxisVector point;   ///< [mm, rad]
  AxisVector first;   ///< direction; its XYZ part has length 1 where XYZ move
  AxisVector second;  ///< curvature vector [1/mm]
  AxisVector third;   ///< [1/mm²]
};

/// Point at path length `s` of a segment, 0 ≤ s ≤ length. The ends are the nodes, to the bit.
AxisVector point_at(const Path& path, std::size_t segment, double s);

/// Point and derivatives. Accuracy 1e-12 relative for lines and circular arcs, 1e-10 for spirals and splines.
Frame frame_at(const Path& path, std::size_t segment, double s);

/// Point at a share 0 … 1 of the own parameter of a spline or blend.
AxisVector point_at_share(const Path& path, std::size_t segment, double share);

/// Derivatives by path length at a share 0 … 1 of the own parameter of a spline or blend: for sampling, where it does not
/// matter how long the way to the point is.
ParameterDerivatives derivatives_at_share(const Path& path, std::size_t segment, double share);

/// Length by that share there [mm]: how unevenly the own parameter runs.
double parameter_speed(const Path& path, std::size_t segment, double share);

/// Directions at a segment's ends (Frame::first at 0 and at length).
AxisVector start_direction(const Path& path, std::size_t segment);
AxisVector end_direction(const Path& path, std::size_t segment);

/// Whether a node, neither first nor last, lies between two pieces of one spline that runs through it with one direction.
bool is_inside_spline(const Path& path, std::size_t node);

/// Row of Moves under the tool at path length `s` of a segment. O(log handovers).
std::uint32_t move_at(const Path& path, std::size_t segment, double s);

/// Whether a segment is a straight one on which all axes move evenly, as the path tells them.
inline bool is_even_line(const Path& path, std::size_t segment) {
  return path.kind[segment] == SegmentKind::line && path.turn_of(segment) == nullptr;
}

/// True where none of X, Y, Z move, so that path length is in degrees.
bool is_rotary_only(const Path& path, std::size_t segment);

/// What length means along a segment.
inline Metric metric_along(const Path& path, std::size_t segment) {
  return Metric::along(is_rotary_only(path, segment));
}

}  // namespace toolpace
