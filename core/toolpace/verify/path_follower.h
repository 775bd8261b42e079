#pragma once
/// Walks a polyline of setpoints and a path at once, never backwards, within a distance: the Fréchet test, as a stream.

#include <cstdint>
#include <vector>

#include "toolpace/verify/path_vertices.h"

namespace toolpace {

/// Where a setpoint is on the path: on chord `cell` (from vertex cell to cell + 1), at `t` of it.
struct PathMatch {
  std::size_t cell = 0;
  double t = 0.0;         ///< 0 … 1
  double distance = 0.0;  ///< [mm] to the chord there
  /// Range of chords that the setpoint may be on.
  std::size_t first_cell = 0, last_cell = 0;
};

/// There is a walk along both within ε exactly if the reachable part of the free-space diagram gets to its far corner.
/// Its boundary is kept column by column: for each chord of the path the stretch that the present setpoint may be
/// matched to. Self-crossings and strokes that run back over themselves are told apart by order, and a stroke that was
/// left out or a vertex that was cut is noticed, which distances to the nearest point are blind to.
/// @source Alt and Godau 1995, "Computing the Fréchet distance between two polygonal curves", section 3
class PathFollower {
 public:
  /// @param tolerance  [mm] how far a setpoint may be from the path
  PathFollower(PathVertices& vertices, double tolerance, bool rotary);

  /// Takes the first setpoint. @return false if the path does not begin there
  bool start(const AxisVector& point);
  /// Moves on to the next setpoint.
  ///
  /// @param slack  [mm] how much farther the path may be from the straight line between the two setpoints
  /// @return false if no walk gets there; the follower is then of no more use
  bool advance(const AxisVector& from, const AxisVector& to, double slack);
  /// Whether the end of the path may be matched to the present setpoint.
  bool reaches_end();

  const PathMatch& match() const { return match_; }

 private:
  struct Stretch {
    std::size_t cell;
    double low, high;
  };
  struct Interval {
    double low = 1.0, high = 0.0;
    bool empty() const { return low > high; }
  };
  Interval inside(const AxisVector& centre, const AxisVector& a, const AxisVector& b, double radius) const;
  double dot(const AxisVector& a, const AxisVector& b) const;
  PathMatch nearest_on_chord(const Stretch& stretch, const AxisVector& point);
  void take_match(const AxisVector& point);

  PathVertices& vertices_;
  double tolerance_;
  bool rotary_;
  std::vector<Stretch> reachable_, next_;
  std::vector<PathMatch> places_;  ///< as near as chords can tell
  PathMatch match_;
};

}  // namespace toolpace
