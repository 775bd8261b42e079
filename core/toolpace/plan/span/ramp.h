#pragma once
/// One side of a bridge between speed caps: jerk up, constant acceleration, jerk down.

#include <cmath>

namespace toolpace::detail {

/// The seven-phase ramp between a low and a high speed, with its derivatives; slowing down is the same seen backwards.
struct SpanRamp {
  double slack;  ///< reciprocal jerk [s³/mm]
  double top;    ///< largest acceleration [mm/s²]
  double knee;   ///< change of speed from which the acceleration is held [mm/s]
  double slope;  ///< reciprocal of top
  double jerk;   ///< [mm/s³]

  SpanRamp(double acceleration, double jerk_limit)
      : slack(1 / jerk_limit),
        top(acceleration),
        knee(acceleration * acceleration * slack),
        slope(1 / acceleration),
        jerk(jerk_limit) {}

  /// Peak acceleration of a ramp by dv.
  double peak(double dv) const { return dv < knee ? std::sqrt(dv * jerk) : top; }

  /// Time of constant acceleration in it.
  double hold(double dv) const { return dv < knee ? 0.0 : dv * slope - top * slack; }

  double length(double from, double dv) const {
    const double time = dv < knee ? 2 * std::sqrt(dv * slack) : dv * slope + top * slack;
    return (from + dv / 2) * time;
  }

  /// Length of a ramp whose high end is dv > 0 above `from`, and its derivative after dv.
  struct Slope {
    double length, per_dv;
  };

  Slope differentiate(double from, double dv) const {
    const double mean = from + dv / 2;
    if (dv < knee) {
      const double root = std::sqrt(dv * slack);
      return {2 * mean * root, root + mean * slack / root};
    }
    const double time = dv * slope + top * slack;
    return {mean * time, time / 2 + mean * slope};
  }
};

}  // namespace toolpace::detail
