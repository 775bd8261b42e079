#pragma once
/// One window of a motion made faster or slower, place by place, so that it uses the limits fully.

#include <array>
#include <cstddef>
#include <vector>

#include "toolpace/base/axes.h"

namespace toolpace::detail::retime {

/// The moving axes, and one more for the path itself where it is limited.
inline constexpr std::size_t kMostAxes = kAxisCount + 1;

/// What each axis may use, with a knot interval as the unit of time; may be infinite.
struct StepLimits {
  std::size_t count = 0;
  std::array<double, kMostAxes> acceleration, jerk;
};

/// What a motion does in one knot interval: derivatives of each axis by time in intervals.
struct IntervalUse {
  std::array<double, kMostAxes> first, second, third;
  double fastest;  ///< largest b that the speed limits allow
};

/// Minimises the time Σ 1/√b of a motion p(u(t)), b = u̇², u in intervals, within
///   |p″·b + p′·b′/2| ≤ A,   √b·|p‴·b + 3/2·p″·b′ + 1/2·p′·b″| ≤ J,   b ≤ fastest,
/// b a quadratic B-spline with a coefficient an interval and one more at each end, its rows at the middles of the intervals.
/// Log-barrier Newton steps on a pentadiagonal system, the curvature of the jerk rows left out; no step breaks a limit. A row
/// that is broken at the start may stay so, but not become worse, and is pressed upon to mend.
/// @source Verscheure et al. 2009 (time-optimal path tracking in b); Debrouwere et al. 2013 (jerk rows)
class WindowRetimer {
 public:
  /// @param pinned_begin, pinned_end  whether b has to stay 1 there, else the scale of time is even over a few intervals
  /// @param weight  of the barrier in the end: each row costs about that share of an interval
  /// @return the coefficients of b, count + 2
  const std::vector<double>& run(const IntervalUse* use, std::size_t count, const StepLimits& limits, bool pinned_begin,
                                 bool pinned_end, double weight);

 private:
  struct Rows;
  struct Cell;
  void find_room();
  void assemble(double weight);
  void add_interval(std::size_t k, double weight, Cell& cell) const;
  void tie(std::size_t j);
  void pin(std::size_t j);
  bool solve();
  double longest_step() const;
  bool keeps_limits(std::size_t k, double share) const;

  const IntervalUse* use_ = nullptr;
  const StepLimits* limits_ = nullptr;
  std::size_t count_ = 0;
  bool pinned_begin_ = false, pinned_end_ = false;
  std::vector<double> b_, gradient_, step_;
  std::vector<std::array<double, 3>> band_;  // diagonal and two above
  std::vector<double> room_;                 // of each row, as a multiple of its limit: 1, or more where it is broken
};

}  // namespace toolpace::detail::retime
