#pragma once
/// One side of a bridge between speed caps: jerk up, constant acceleration, jerk down.

#include <cmath>

namespace toolpace::detail {

/// Speeds up from a low end to a high end, both with zero acceleration (or slows down, seen backwards). The jerk at the
/// low end belongs to the kernel there, that at the high end to the bridge; with equal jerks this is the seven-phase
/// ramp.
struct SpanRamp {
  double low;   ///< reciprocal jerk at the low end [s³/mm]
  double high;  ///< reciprocal jerk at the high end [s³/mm]
  double top;   ///< largest acceleration [mm/s²]
  double half;  ///< mean of low and high: Δ = half · x² for a peak acceleration x < top
  double skew;  ///< (low² − high²)/6, 0 for equal jerks

  SpanRamp(double jerk_low, double jerk_high, double acceleration)
      : low(1 / jerk_low),
        high(1 / jerk_high),
        top(acceleration),
        half((low + high) / 2),
        skew((low - high) * (low + high) / 6) {}

  /// What a ramp by dv takes.
  struct Extent {
    double peak;    ///< acceleration held [mm/s²]
    double hold;    ///< time of constant acceleration [s]
    double length;  ///< [mm]
  };

  Extent extent(double from, double dv) const {
    const double peak = std::sqrt(dv / half);
    const double to = from + dv;
    if (peak <= top) return {peak, 0.0, peak * (from * low + to * high + skew * (peak * peak))};
    const double hold = (dv - half * (top * top)) / top;
    const double means = from + to + (top * top) * (low - high) / 2;
    return {top, hold, top * (from * low + to * high + skew * (top * top)) + means / 2 * hold};
  }

  /// Length of a ramp whose high end is dv above `from`, and its derivative after dv.
  struct Slope {
    double length, per_dv;
  };

  Slope slope(double from, double dv) const {
    const double peak = std::sqrt(dv / half);
    const double to = from + dv;
    if (peak <= top) {
      const double weight = from * low + to * high;
      return {peak * (weight + skew * (peak * peak)),
              (weight + 3 * skew * (peak * peak)) / (2 * half * peak) + peak * high};
    }
    const double hold = (dv - half * (top * top)) / top;
    const double means = from + to + (top * top) * (low - high) / 2;
    return {top * (from * low + to * high + skew * (top * top)) + means / 2 * hold,
            top * high + hold / 2 + means / (2 * top)};
  }
};

}  // namespace toolpace::detail
