#pragma once
/// The least time around a speed cap that every jerk-limited motion needs.

namespace toolpace::detail {

/// The surroundings of a point that no motion passes faster than at `cap`.
struct Valley {
  double cap;            ///< [mm/s] > 0
  double before, after;  ///< lengths of path on either side [mm] > 0
  double deceleration;   ///< largest before the point [mm/s²]
  double acceleration;   ///< largest behind it [mm/s²]
  double jerk;           ///< largest on either side [mm/s³]
};

/// Lower bound of the time over both sides together [s].
///
/// Whoever passes the point with acceleration a covers the way behind it no faster than with full jerk from (cap, a) on up
/// to the full acceleration, and the same backwards for the way before it: the time is at least the sum of these two for
/// the best a, |a| ≤ √(2·J·cap). The first falls with a, the second rises; both are convex in a as long as a² ≤ 1.7·J·cap on
/// the side where the motion starts out slower (there 2v ≥ a·t, which makes the second derivative positive). So tangents
/// bound the minimum from below; the rest of the range is bounded by monotony.
/// Accuracy of the minimum 1e-5 relative, from below.
double valley_time(const Valley& valley);

}  // namespace toolpace::detail
