#pragma once
/// Arcs as controllers run them: chords of equal angle.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "toolpace/nc/moves.h"

namespace toolpace::detail::controller {

/// An arc about an axis, from its first point on.
struct ChordArc {
  Eigen::Vector3d from, to, centre;
  Eigen::Vector3d across, ahead;  ///< of the first point: radius vector, and the same turned by 90° the way it goes
  double radius = 0;              ///< [mm] at the first point
  double sweep = 0;               ///< [rad] > 0
  double rise = 0;                ///< [mm] along the axis

  /// @param turned  run the other way round
  ChordArc(const Moves& moves, std::size_t row, const Eigen::Vector3d& start, bool turned = false) {
    const ArcDetail& arc = moves.arcs[moves.detail[row]];
    const Eigen::Vector3d normal = arc.normal;
    from = start;
    to = moves.end[row].head<3>();
    double signed_sweep = arc.sweep;
    if (turned) {
      const bool is_full = std::abs(std::abs(signed_sweep) - kTwoPi) < 1e-9;
      signed_sweep = is_full ? -signed_sweep : signed_sweep - std::copysign(kTwoPi, signed_sweep);
    }
    const Eigen::Vector3d out = from - arc.centre;
    across = out - normal * normal.dot(out);
    centre = from - across;
    radius = across.norm();
    sweep = std::abs(signed_sweep);
    ahead = normal.cross(across) * (signed_sweep < 0 ? -1.0 : 1.0);
    rise = normal.dot(to - from);
    axis = normal;
  }

  /// Where `part` of the way is done, 0 … 1.
  Eigen::Vector3d at(double part) const {
    const double angle = sweep * part;
    return centre + std::cos(angle) * across + std::sin(angle) * ahead + (rise * part) * axis;
  }

  /// Calls take(point) for the ends of `count` chords.
  template <class Take>
  void for_each_chord(std::size_t count, const Take& take) const {
    const double part = 1.0 / static_cast<double>(count);
    for (std::size_t i = 1; i < count; ++i) take(at(static_cast<double>(i) * part));
    take(to);
  }

  Eigen::Vector3d axis;
};

}  // namespace toolpace::detail::controller
