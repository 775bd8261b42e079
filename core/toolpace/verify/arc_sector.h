#pragma once
/// A short stretch of an arc, with exact distances from points.

#include <Eigen/Core>

#include "toolpace/path/arc.h"

namespace toolpace {

/// Stretch of a curve within a distance of a point, by a share 0 … 1 of the stretch; empty if low > high.
struct CurveInterval {
  double low = 1.0, high = 0.0;
  double nearest = 0.0;   ///< share of the place nearest to the point; may lie outside of 0 … 1
  double distance = 0.0;  ///< [mm] there
  bool empty() const { return low > high; }
};

/// An arc, helix or spiral of at most kWidest, about its middle. Rotary axes rest.
class ArcSector {
 public:
  static constexpr double kWidest = 1.0;  ///< [rad], little enough that the distance to a point near by has one minimum

  ArcSector(const ArcCurve& arc, double begin_angle, double end_angle);

  Eigen::Vector3d point(double share) const;

  /// Where the sector is within `radius` of the point; exact to 1e-6 of the radius.
  CurveInterval within(const Eigen::Vector3d& point, double radius) const;
  double distance(const Eigen::Vector3d& point, double share) const;

  /// At most how high the arc stands over the chord between two of its places [mm]; exact to a quarter of a percent for 20°.
  double bulge(double from, double to) const;

 private:
  /// A point in cylindrical coordinates about the sector's middle.
  struct Local {
    double radius, angle, height;
  };
  Local local(const Eigen::Vector3d& point) const;
  double square(const Local& at, double angle) const;
  double half_slope(const Local& at, double angle) const;
  double half_bend(const Local& at, double angle) const;
  double nearest_angle(const Local& at) const;
  double edge(const Local& at, double inside, double outside, double guess, double radius_square) const;
  double angle_of(double share) const { return (2 * share - 1) * half_; }
  double share_of(double angle) const { return angle / (2 * half_) + 0.5; }

  Eigen::Vector3d centre_, outward_, along_, normal_;  // at the middle; the centre is at its height
  double radius_;                                      // [mm] at the middle
  double widening_, rise_;                             // [mm/rad]
  double half_;                                        // [rad]
};

}  // namespace toolpace
