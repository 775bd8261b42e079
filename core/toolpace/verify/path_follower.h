#pragma once
/// Walks a polyline of setpoints and a path at once, never backwards, within a distance: the Fréchet test, as a stream.

#include <cstdint>
#include <vector>

#include "toolpace/verify/path_vertices.h"

namespace toolpace {

/// Where a setpoint is on the path: in cell `cell` (from vertex cell to cell + 1), at the share `t` of it.
struct PathMatch {
  std::size_t cell = 0;
  double t = 0.0;         ///< 0 … 1
  double distance = 0.0;  ///< [mm] there; of chords, to the chord
  /// Range of cells that the setpoint may be on.
  std::size_t first_cell = 0, last_cell = 0;
};

/// How much farther the path may be from the straight line between two setpoints than from the setpoints [mm].
struct Slack {
  double between = 0.0;    ///< what the motion bulges from its chord
  double at_corner = 0.0;  ///< about a corner that the motion passes exactly, with a step of speed
  bool from_path = true;   ///< whether the first of the two is on the path exactly
};

/// There is a walk along both within ε exactly if the reachable part of the free-space diagram gets to its far corner.
/// Its boundary is kept column by column: for each cell of the path the stretch that the present setpoint may be
/// matched to. Self-crossings and strokes that run back over themselves are told apart by order, and a stroke that was
/// left out or a vertex that was cut is noticed, which distances to the nearest point are blind to. Each setpoint costs the
/// cells in its reach, so the whole test is linear in rows and blocks.
///
/// ε of a place is the smaller of the follower's and its segment's tolerance, for setpoints. For points of the path against
/// the straight lines between setpoints it is larger by the slack. On lines that is judged exactly (both are convex there);
/// on sectors of arcs at the setpoints, at the ends of the sector and in the middle of what is passed in a period, where an
/// arc stands out farthest; other curves are chords, and ε is larger by their sagitta.
/// @source Alt and Godau 1995, "Computing the Fréchet distance between two polygonal curves", section 3
class PathFollower {
 public:
  /// @param tolerance  [mm] how far a setpoint may be from the path
  PathFollower(PathVertices& vertices, double tolerance, bool rotary);

  /// Takes the first setpoint. @return false if the path does not begin there
  bool start(const AxisVector& point);
  /// Moves on to the next setpoint.
  ///
  /// @return false if no walk gets there; the follower is then of no more use
  bool advance(const AxisVector& from, const AxisVector& to, const Slack& slack);
  /// Whether the end of the path may be matched to the present setpoint.
  bool reaches_end();

  const PathMatch& match() const { return match_; }

 private:
  struct Stretch {
    std::size_t cell;
    double low, high;
    double nearest, distance;  ///< see CurveInterval
  };
  /// The setpoints' step under way.
  struct Step {
    const AxisVector& from;
    const AxisVector& to;
    const Slack& slack;
    std::size_t cell_of_to;  ///< the first that `to` is exactly on; kUnknown until it is asked for
  };
  double dot(const AxisVector& a, const AxisVector& b) const;
  double radius(const PathVertex& end) const;
  double node_radius(std::size_t vertex);
  CurveInterval inside(const AxisVector& centre, const AxisVector& a, const AxisVector& b, double radius) const;
  CurveInterval inside_cell(std::size_t cell, const AxisVector& point);
  double distance_at(std::size_t cell, double t, const AxisVector& point);
  bool bulges(std::size_t cell, double low, double high, const Step& step);
  CurveInterval at_vertex(std::size_t vertex, Step& step);
  bool is_passed_exactly(std::size_t vertex, Step& step);
  void reach_cell(std::size_t cell, const Stretch* left, CurveInterval& bottom, Step& step);
  PathMatch nearest_in(const Stretch& stretch, const AxisVector& point);
  void take_match(const AxisVector& point);

  PathVertices& vertices_;
  double tolerance_;
  bool rotary_;
  std::vector<Stretch> reachable_, next_;
  std::vector<PathMatch> places_;  ///< as near as chords can tell
  PathMatch match_;
};

}  // namespace toolpace
