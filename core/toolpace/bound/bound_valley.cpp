#include "toolpace/bound/bound_valley.h"

#include <algorithm>
#include <cmath>

namespace toolpace::detail {
namespace {

/// a² ≤ this · J · cap: where the times are convex.
constexpr double kConvex = 1.7;
constexpr double kClose = 1e-5;
constexpr int kMaxSteps = 24, kMaxNewton = 60;
/// Newton's steps smaller than this share leave an error far below rounding.
constexpr double kSettled = 1e-9;

/// Accelerations without limit, as a number to calculate with.
constexpr double kUnlimited = 1e150;

/// One side of the valley: covering a way from (cap, a) on with full jerk, up to the full acceleration.
struct Side {
  double cap, way, top, jerk;

  struct Time {
    double time, per_a;
  };

  struct State {
    double covered, speed;
  };

  State state(double a, double t) const {
    const double until = (top - a) / jerk, building = std::min(t, until), rest = t - building;
    const double speed = cap + building * (a + building * jerk / 2);
    return {building * (cap + building * (a / 2 + building * jerk / 6)) + rest * (speed + rest * top / 2),
            speed + rest * top};
  }

  /// Newton's steps inside a bracket.
  Time time(double a) const {
    double low = 0, high = std::min(way / cap, std::cbrt(6 * way / jerk));
    while (state(a, high).covered < way) {
      low = high;
      high *= 2;
    }
    double t = high;
    for (int i = 0; i < kMaxNewton; ++i) {
      const State s = state(a, t);
      (s.covered < way ? low : high) = t;
      double next = t - (s.covered - way) / s.speed;
      if (!(next >= low && next <= high)) next = (low + high) / 2;
      const double change = std::abs(next - t);
      t = next;
      if (change <= kSettled * t) break;
    }
    const double building = std::min(t, (top - a) / jerk);
    return {t, -building * (t - building / 2) / state(a, t).speed};
  }
};

struct Range {
  double from, to;
};

/// Bound over accelerations in a range, by monotony: `gaining` is no faster than at its end, `losing` than at its begin. In
/// parts, where the whole does not do.
double bound_beyond(const Side& gaining, const Side& losing, const Range& range, double wanted) {
  constexpr int kParts = 16;
  const double whole = gaining.time(range.to).time + losing.time(-range.from).time;
  if (whole >= wanted) return whole;
  double bound = wanted;
  for (int i = 0; i < kParts; ++i) {
    const double from = range.from + (range.to - range.from) * i / kParts;
    const double to = range.from + (range.to - range.from) * (i + 1) / kParts;
    bound = std::min(bound, gaining.time(to).time + losing.time(-from).time);
  }
  return bound;
}

}  // namespace

double valley_time(const Valley& v) {
  const double speeding = std::min(v.acceleration, kUnlimited), slowing = std::min(v.deceleration, kUnlimited);
  const Side after{v.cap, v.after, speeding, v.jerk}, before{v.cap, v.before, slowing, v.jerk};
  const double edge = std::sqrt(kConvex * v.jerk * v.cap), last = std::sqrt(2 * v.jerk * v.cap);
  struct Point {
    double a, time, slope;
  };
  const auto at = [&](double a) {
    const Side::Time x = after.time(a), y = before.time(-a);
    return Point{a, x.time + y.time, x.per_a - y.per_a};
  };
  Point low = at(-std::min(edge, slowing)), high = at(std::min(edge, speeding));
  double bound = std::min(low.time, high.time);
  if (low.slope < 0 && high.slope > 0) {
    for (int i = 0; i < kMaxSteps; ++i) {
      const double a = (high.time - low.time + low.slope * low.a - high.slope * high.a) / (low.slope - high.slope);
      bound = low.time + low.slope * (a - low.a);
      const Point middle = at(std::clamp(a, low.a, high.a));
      if (middle.slope == 0) bound = middle.time;
      if (middle.time - bound <= kClose * middle.time) break;
      (middle.slope < 0 ? low : high) = middle;
    }
  }
  if (edge < speeding) bound = std::min(bound, bound_beyond(after, before, {edge, std::min(last, speeding)}, bound));
  if (edge < slowing) bound = std::min(bound, bound_beyond(before, after, {edge, std::min(last, slowing)}, bound));
  return bound;
}

}  // namespace toolpace::detail
