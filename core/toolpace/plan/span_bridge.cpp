#include "toolpace/plan/span_bridge.h"

#include <algorithm>
#include <cmath>

#include "toolpace/plan/span_ramp.h"

namespace toolpace::detail {
namespace {

/// Where Newton's steps are smaller than this share of the unknown the next one would be below rounding.
constexpr double kSettled = 1e-8;
constexpr int kMaxSteps = 60;
/// Accelerations that agree to this share differ by rounding only.
constexpr double kSteeper = 1 - 1e-9;

/// Peak over two bottoms, as the rise above the higher one [mm/s]: length(low side) + length(high side) = gap, the
/// unknown being the root w of the rise above the higher bottom, in which the lengths are smooth and convex: Newton's
/// steps from above cannot miss.
double solve_peak(const SpanRamp& low, double low_bottom, const SpanRamp& high, double high_bottom, double gap) {
  const double step = high_bottom - low_bottom;
  // From above: what acceleration alone would allow, and what the high side alone would at full jerk.
  const double a = low.top, d = high.top;
  const double square = (2 * a * d * gap + d * (low_bottom * low_bottom) + a * (high_bottom * high_bottom)) / (a + d);
  const double above = std::max(square - high_bottom * high_bottom, 0.0) / (std::sqrt(square) + high_bottom);
  double w = std::sqrt(above / high.half);
  if (high_bottom > 0) w = std::min(w, std::max(gap / (high_bottom * 2 * high.half), 0.0));
  // A start below the root costs one step: the next one is above it.
  for (int i = 0; i < kMaxSteps; ++i) {
    if (!(w > 0)) return 0.0;
    const double dv = high.half * w * w;
    const SpanRamp::Slope there = high.slope(high_bottom, dv);
    const SpanRamp::Slope here = low.slope(low_bottom, step + dv);
    const double excess = here.length + there.length - gap;
    const double next = w - excess / ((here.per_dv + there.per_dv) * 2 * high.half * w);
    const double change = std::abs(next - w);
    w = next;
    if (change <= kSettled * w) break;
  }
  return high.half * w * w;
}

/// What is left of a flank's length when it meets the high kernel (reciprocal jerk `own`) with acceleration y.
struct Flank {
  const SpanRamp& ramp;
  double low_bottom, high_bottom, own, gap;

  double rise(double y) const { return (own + ramp.high) / 2 * (y * y); }

  SpanRamp::Slope excess(double y) const {
    const double dv = rise(y), to = high_bottom + dv, dto = (own + ramp.high) * y;
    const SpanRamp::Slope r = ramp.slope(low_bottom, high_bottom - low_bottom + dv);
    const double skew = (ramp.high * ramp.high - own * own) / 6;
    return {r.length - y * (to * ramp.high + high_bottom * own - skew * (y * y)) - gap,
            r.per_dv * dto - to * ramp.high - y * dto * ramp.high - high_bottom * own + 3 * skew * (y * y)};
  }

  /// The acceleration left over, in (0, top); negative where there is none.
  double solve() const {
    if (!(excess(ramp.top).length <= 0)) return -1.0;
    double low = 0, high = ramp.top, y = ramp.top / 2;
    if (high_bottom > 0) {
      const double first = ramp.extent(low_bottom, high_bottom - low_bottom).length - gap;
      y = std::clamp(first / (high_bottom * (own + ramp.high)), 1e-12 * high, high);
    }
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
};

Bridge over_peak(const Kernel& near, const Kernel& far, const SpanLimits& limits, double gap) {
  const SpanRamp up(near.up_jerk, limits.up_jerk, limits.up);
  const SpanRamp down(far.down_jerk, limits.down_jerk, limits.down);
  Bridge b{BridgeKind::peak, 0, 0, near.right, far.left, 0, limits};
  const double step = far.bottom - near.bottom;
  const double rise = step >= 0 ? solve_peak(up, near.bottom, down, far.bottom, gap)
                                : solve_peak(down, far.bottom, up, near.bottom, gap);
  b.peak = std::max(near.bottom, far.bottom) + rise;
  b.leave = std::min(up.top, std::sqrt((rise + std::max(step, 0.0)) / up.half));
  b.meet = -std::min(down.top, std::sqrt((rise + std::max(-step, 0.0)) / down.half));
  return b;
}

Bridge upwards(const Kernel& near, const Kernel& far, const SpanLimits& limits) {
  const SpanRamp up(near.up_jerk, limits.up_jerk, limits.up);
  const auto ramp = up.extent(near.bottom, far.bottom - near.bottom);
  if (ramp.length < far.left - near.right) return over_peak(near, far, limits, far.left - near.right);
  const double at = near.right + ramp.length;
  if (at <= far.right) return {BridgeKind::rise, ramp.peak, 0.0, near.right, at, far.bottom, limits};
  const Flank flank{up, near.bottom, far.bottom, 1 / far.up_jerk, far.right - near.right};
  const double y = flank.solve();
  if (y < 0) return {};
  Bridge b{BridgeKind::rising_flank, 0, y, near.right, far.right, far.bottom + flank.rise(y), limits};
  b.leave = std::min(up.top, std::sqrt((far.bottom - near.bottom + flank.rise(y)) / up.half));
  // With unequal jerks the near kernel may be the flatter one: then its curve stays below the far one.
  if (b.leave < y * kSteeper) return {};
  b.leave = std::max(b.leave, y);
  return b;
}

Bridge downwards(const Kernel& near, const Kernel& far, const SpanLimits& limits) {
  const SpanRamp down(far.down_jerk, limits.down_jerk, limits.down);
  const auto ramp = down.extent(far.bottom, near.bottom - far.bottom);
  if (ramp.length < far.left - near.right) return over_peak(near, far, limits, far.left - near.right);
  const double at = far.left - ramp.length;
  if (at >= near.left) return {BridgeKind::fall, 0.0, -ramp.peak, at, far.left, near.bottom, limits};
  const Flank flank{down, far.bottom, near.bottom, 1 / near.down_jerk, far.left - near.left};
  const double x = flank.solve();
  Bridge b{BridgeKind::near_is_idle, 0, 0, 0, 0, 0, limits};
  if (x < 0) return b;
  const double meet = std::min(down.top, std::sqrt((near.bottom - far.bottom + flank.rise(x)) / down.half));
  if (meet < x * kSteeper) return b;
  return {BridgeKind::falling_flank, -x, -std::max(meet, x), near.left, far.left, near.bottom + flank.rise(x), limits};
}

}  // namespace

Bridge bridge(const Kernel& near, const Kernel& far, const SpanLimits& limits) {
  return far.bottom >= near.bottom ? upwards(near, far, limits) : downwards(near, far, limits);
}

}  // namespace toolpace::detail
