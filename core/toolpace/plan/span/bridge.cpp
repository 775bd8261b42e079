#include "toolpace/plan/span/bridge.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace toolpace::detail {
namespace {

/// Where Newton's steps are smaller than this share of the unknown the next one would be below rounding.
constexpr double kSettled = 1e-8;
constexpr double kSettledCubically = 1e-5;  // of Halley's steps
constexpr int kMaxSteps = 60;

/// The accelerations at which two ramps to one speed peak.
struct Peaks {
  double low,
      high;  ///< of the ramp from the lower bottom and from the higher one; high < 0: what a flank has left over
};

/// Bridge of two ramps neither of which holds its acceleration, under one jerk.
///
/// With p, w the peaks, p² − w² = K = J·(high − low), and s = p + w the lengths (low + vp)·p/J + (high + vp)·w/J = gap become
///   s⁴/4J + (low + high)·s² − J·gap·s − K·(high − low)/4 = 0.
/// Its signs change once: there is one positive root. The left side is convex; from above Halley's steps cannot miss.
/// w < 0 where even the ramp to the higher bottom alone is longer than the gap; then |w| is the acceleration left over there.
std::optional<Peaks> solve_sharp(const SpanRamp& ramp, double low_bottom, double high_bottom, double gap) {
  const double step = high_bottom - low_bottom, both = low_bottom + high_bottom;
  const double square = step * ramp.jerk, force = gap * ramp.jerk;
  if (!(gap > 0) || square >= ramp.top * ramp.top) return {};
  const double quarter = ramp.slack / 4, last = step * square / 4;
  double s = (force + std::sqrt(force * force + 4 * both * last)) / (2 * both);
  if (!(quarter * s * s <= both)) s = std::max(2 * std::cbrt(force * ramp.jerk), 1.2 * std::sqrt(square));
  if (both < 0) s += 2 * std::sqrt(-both * ramp.jerk);  // between turns, which have bottoms below 0
  for (int i = 0; i < kMaxSteps; ++i) {
    const double rise = quarter * s * s;
    const double f = ((rise + both) * s - force) * s - last;
    const double slope = (4 * rise + 2 * both) * s - force, half_bend = 6 * rise + both;
    const double change = f * slope / (slope * slope - f * half_bend);
    s -= change;
    if (!(std::abs(change) > kSettledCubically * s)) break;
  }
  const double difference = square / s;
  return Peaks{(s + difference) / 2, (s - difference) / 2};
}

/// What a peak has to fit over.
struct Gap {
  const SpanRamp& low;   ///< on the side of the lower bottom
  const SpanRamp& high;  ///< on the side of the higher one
  double low_bottom, high_bottom;
  double length;       ///< [mm]
  double step_length;  ///< of the ramp from the lower bottom to the higher speed, ≤ length
};

/// Upper bound of the peak's root w: what acceleration alone would allow, and what is left of the gap behind the ramp to the
/// higher speed, at full jerk on the high side.
double bound_root(const Gap& g) {
  const double a = g.low.top, d = g.high.top;
  const double high_square = g.high_bottom * g.high_bottom;
  const double square = (2 * a * d * g.length + d * (g.low_bottom * g.low_bottom) + a * high_square) / (a + d);
  const double peak = std::sqrt(square);
  const double rise =
      g.high_bottom < 0 ? peak - g.high_bottom : std::max(square - high_square, 0.0) / (peak + g.high_bottom);
  double w = std::sqrt(std::max(rise, 0.0) * g.high.jerk);
  if (g.high_bottom > 0) {
    w = std::min(w, std::max(g.length - g.step_length, 0.0) * g.high.jerk / (2 * g.high_bottom));
  }
  return w;
}

/// Peak over two bottoms, as the rise w²/J above the higher one [mm/s]: length(low side) + length(high side) = gap. In w
/// the lengths are smooth and convex: Newton's steps from above cannot miss.
double solve_peak(const Gap& g) {
  if (g.low.jerk == g.high.jerk) {
    const auto sharp = solve_sharp(g.low, g.low_bottom, g.high_bottom, g.length);
    if (sharp && sharp->low <= g.low.top && sharp->high <= g.high.top) {
      return sharp->high > 0 ? sharp->high * sharp->high * g.high.slack : 0.0;
    }
  }
  const double step = g.high_bottom - g.low_bottom;
  const double u = g.high.slack;
  double w = bound_root(g);
  for (int i = 0; i < kMaxSteps && w > 0; ++i) {
    const double dv = w * w * u;
    const double gain = 2 * w * u;  // of dv by w
    double length, slope;
    if (w < g.high.top) {
      length = w * u * (2 * g.high_bottom + dv);
      slope = u * (2 * g.high_bottom + 3 * dv);
    } else {
      const double time = dv * g.high.slope + g.high.top * u;
      length = (g.high_bottom + dv / 2) * time;
      slope = gain * (time / 2 + (g.high_bottom + dv / 2) * g.high.slope);
    }
    const SpanRamp::Slope low = g.low.differentiate(g.low_bottom, step + dv);
    const double next = w - (length + low.length - g.length) / (slope + low.per_dv * gain);
    const double change = std::abs(next - w);
    w = next;
    if (change <= kSettled * w) break;
  }
  return w > 0 ? w * w * u : 0.0;
}

/// Acceleration y left over when a ramp from `low_bottom` meets the kernel at `high_bottom`, which is too near to be met with
/// none: in (0, top), negative where even the full acceleration does not get there.
double solve_flank(const SpanRamp& ramp, double low_bottom, double high_bottom, double gap) {
  const auto sharp = solve_sharp(ramp, low_bottom, high_bottom, gap);
  if (sharp && sharp->low <= ramp.top) return std::max(0.0, -sharp->high);
  if (!(high_bottom > 0)) return -1.0;
  const double u = ramp.slack, step = high_bottom - low_bottom;
  const auto excess = [&](double y) {
    const double dv = y * y * u;
    const SpanRamp::Slope r = ramp.differentiate(low_bottom, step + dv);
    return SpanRamp::Slope{r.length - y * u * (2 * high_bottom + dv) - gap,
                           r.per_dv * (2 * y * u) - u * (2 * high_bottom + 3 * dv)};
  };
  if (!(excess(ramp.top).length <= 0)) return -1.0;
  double low = 0, high = ramp.top;
  double y = std::clamp((ramp.length(low_bottom, step) - gap) * ramp.jerk / (2 * high_bottom), 1e-12 * high, high);
  for (int i = 0; i < kMaxSteps; ++i) {
    const SpanRamp::Slope f = excess(y);
    (f.length > 0 ? low : high) = y;
    double next = y - f.length / f.per_dv;
    if (!(next >= low && next <= high)) next = (low + high) / 2;
    const double change = std::abs(next - y);
    y = next;
    if (change <= kSettled * y) break;
  }
  return y;
}

Bridge upwards(const Kernel& near, const Kernel& far, const SpanLimits& limits) {
  const SpanRamp& up = limits.up;
  const double step = far.bottom - near.bottom;
  const double ramp = up.length(near.bottom, step), gap = far.left - near.right;
  if (ramp < gap) {
    const double rise = solve_peak({up, limits.down, near.bottom, far.bottom, gap, ramp});
    return {up.peak(step + rise), -limits.down.peak(rise), near.right, far.left, far.bottom + rise, BridgeKind::peak};
  }
  const ExactPlace at = near.right + ramp;
  if (at <= far.right) return {up.peak(step), 0.0, near.right, at, far.bottom, BridgeKind::rise};
  const double y = solve_flank(up, near.bottom, far.bottom, far.right - near.right);
  if (y < 0) return {};
  const double rise = y * y * up.slack;
  return {std::max(y, up.peak(step + rise)), y, near.right, far.right, far.bottom + rise, BridgeKind::rising_flank};
}

Bridge downwards(const Kernel& near, const Kernel& far, const SpanLimits& limits) {
  const SpanRamp& down = limits.down;
  const double step = near.bottom - far.bottom;
  const double ramp = down.length(far.bottom, step), gap = far.left - near.right;
  if (ramp < gap) {
    const double rise = solve_peak({down, limits.up, far.bottom, near.bottom, gap, ramp});
    return {limits.up.peak(rise), -down.peak(step + rise), near.right, far.left, near.bottom + rise, BridgeKind::peak};
  }
  const ExactPlace at = far.left - ramp;
  if (at >= near.left) return {0.0, -down.peak(step), at, far.left, near.bottom, BridgeKind::fall};
  const double x = solve_flank(down, far.bottom, near.bottom, far.left - near.left);
  if (x < 0) return {.kind = BridgeKind::near_is_idle};
  const double rise = x * x * down.slack;
  return {-x, -std::max(x, down.peak(step + rise)), near.left, far.left, near.bottom + rise, BridgeKind::falling_flank};
}

}  // namespace

Bridge bridge(const Kernel& near, const Kernel& far, const SpanLimits& limits) {
  return far.bottom >= near.bottom ? upwards(near, far, limits) : downwards(near, far, limits);
}

}  // namespace toolpace::detail
