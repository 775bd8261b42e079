#include "toolpace/law/peak_speed.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "toolpace/base/cubic.h"

namespace toolpace {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The two ends of the move: `high` is the faster one.
struct Ends {
  double high, low;
  DurationTerms at_high, at_low;
};

Ends order(const MoveRequest& move, const MoveTerms& terms) {
  if (move.start > move.end) return {move.start, move.end, terms.up, terms.down};
  return {move.end, move.start, terms.down, terms.up};
}

/// Duration and its derivative by the change of speed. dv > 0.
struct Duration {
  double value, slope;
};

Duration differentiate(const DurationTerms& t, double dv) {
  if (dv >= t.threshold) {
    const double value = t.slope * dv + t.offset;
    return value >= t.floor ? Duration{value, t.slope} : Duration{t.floor, 0.0};
  }
  const double value = t.root * std::sqrt(dv);
  return value >= t.floor ? Duration{value, value / (2 * dv)} : Duration{t.floor, 0.0};
}

/// Both durations linear in the change of speed, T = s·Δ + e: a·v² + b·v = c with a = Σs, b = Σe.
/// Zheng (27), fmax = (2L − fs·Tacc − fe·Tdec)/(Tacc + Tdec), is the case s = 0.
struct LinearDuration {
  double slope, offset;
};

double solve_linear(double length, const Ends& e, const LinearDuration& at_high, const LinearDuration& at_low) {
  const double a = at_high.slope + at_low.slope;
  const double b = at_high.offset + at_low.offset;
  const double c =
      2 * length + e.high * (e.high * at_high.slope - at_high.offset) + e.low * (e.low * at_low.slope - at_low.offset);
  if (!(c > 0)) return 0.0;
  return 2 * c / (b + std::sqrt(b * b + 4 * a * c));
}

/// Upper bounds of the root of the excess over the higher speed, from T ≥ root·√Δ and T ≥ slope·Δ.
double bound_root(const MoveRequest& move, const Ends& e) {
  const double step = e.high - e.low;
  double bound = std::sqrt(move.feed - e.high);
  const double roots = e.at_high.root + e.at_low.root;
  if (roots > 0) {
    const double linear = 2 * e.high * e.at_high.root + (e.high + e.low) * e.at_low.root;
    bound = std::min(bound, depressed_cubic_root(linear / roots, 2 * move.length / roots));
  }
  if (step > 0 && e.at_high.root > 0) {  // the tangent at the higher speed
    const double left = move.length - (e.high + e.low) / 2 * e.at_low.duration(step);
    bound = std::min(bound, std::max(left, 0.0) / (e.high * e.at_high.root));
  }
  if (e.at_high.slope + e.at_low.slope > 0) {
    const double v = solve_linear(move.length, e, {e.at_high.slope, 0.0}, {e.at_low.slope, 0.0});
    bound = std::min(bound, std::sqrt(std::max(v - e.high, 0.0)));
  }
  return bound;
}

bool has_floor(const Ends& e) { return e.at_high.floor > 0 || e.at_low.floor > 0; }

/// Which pieces of the two durations decide at an excess of x² over the higher speed.
int piece(const Ends& e, double gain) {
  return (gain >= e.at_high.threshold ? 1 : 0) + (gain + (e.high - e.low) >= e.at_low.threshold ? 2 : 0);
}

/// Newton's method for x = √(v − high). The excess length is convex and increasing in x, so from above it descends
/// monotonically to the root and from below it goes above the root in one step.
double iterate(const MoveRequest& move, const Ends& e) {
  constexpr int kMaxSteps = 60;
  // A step this small leaves an error of its square, unless it crossed from one piece of T to another.
  const double last_step = has_floor(e) ? 1e-15 : 1e-8;
  const double top = std::sqrt(move.feed - e.high);
  double x = bound_root(move, e);
  for (int i = 0; i < kMaxSteps; ++i) {
    const double gain = x * x;
    const double v = e.high + gain;
    if (!(v > e.high)) return e.high;
    const Duration high = differentiate(e.at_high, gain);
    const Duration low = differentiate(e.at_low, v - e.low);
    const double excess = (e.high + v) / 2 * high.value + (e.low + v) / 2 * low.value - move.length;
    const double slope = (high.value + low.value + (e.high + v) * high.slope + (e.low + v) * low.slope) * x;  // 2x·d/dv
    const double next = std::clamp(x - excess / slope, x / 16, top);
    const double change = std::abs(next - x);
    x = next;
    if (change <= last_step * x && piece(e, x * x) == piece(e, gain)) break;
  }
  return e.high + x * x;
}

/// Least length of a move that goes above the higher speed at all: more than the one ramp where durations do not shrink
/// with the change of speed.
double least_length_above(const Ends& e) {
  const double step = e.high - e.low;
  const double low_duration = step > 0 ? e.at_low.duration(step) : e.at_low.floor;
  return e.high * e.at_high.floor + (e.high + e.low) / 2 * low_duration;
}

double length_at(const Ends& e, double v) {
  return (e.high + v) / 2 * e.at_high.duration(v - e.high) + (e.low + v) / 2 * e.at_low.duration(v - e.low);
}

/// The linear piece that T is near a large change of speed, for a first attempt at a closed form.
LinearDuration linear_piece(const DurationTerms& t) {
  if (t.floor > 0) return {0.0, t.floor};
  return {t.slope, t.offset};
}

bool is_on_piece(const DurationTerms& t, double dv) {
  if (!(t.floor > 0)) return t.threshold < kInfinity && dv >= t.threshold;  // jerk alone decides: no linear piece
  return t.duration(dv) <= t.floor;
}

double solve(const MoveRequest& move, const Ends& e) {
  const double linear = solve_linear(move.length, e, linear_piece(e.at_high), linear_piece(e.at_low));
  if (linear >= e.high && is_on_piece(e.at_high, linear - e.high) && is_on_piece(e.at_low, linear - e.low)) {
    return linear;
  }
  if (e.high == e.low && !has_floor(e)) {
    const double roots = e.at_high.root + e.at_low.root;
    const double x = depressed_cubic_root(2 * e.high, roots > 0 ? 2 * move.length / roots : kInfinity);
    if (x * x <= std::min(e.at_high.threshold, e.at_low.threshold)) return e.high + x * x;
  }
  return iterate(move, e);
}

}  // namespace

double peak_speed(const MoveRequest& move, const MoveTerms& terms) {
  const Ends e = order(move, terms);
  if (!(move.feed > e.high)) return e.high;
  if (length_at(e, move.feed) <= move.length) return move.feed;
  if (least_length_above(e) >= move.length) return e.high;
  return std::clamp(solve(move, e), e.high, move.feed);
}

}  // namespace toolpace
