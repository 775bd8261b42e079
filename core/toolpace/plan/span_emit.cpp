#include "toolpace/plan/span_emit.h"

#include <algorithm>

#include "toolpace/plan/span_ramp.h"

namespace toolpace::detail {
namespace {

constexpr PhaseShape kJerk = PhaseShape::constant_jerk;

struct Place {
  double distance, speed, acceleration;
};

/// Place on the kernel where the acceleration is `a`.
Place on_kernel(const Kernel& k, double a) {
  const double time = a / (a > 0 ? k.up_jerk : k.down_jerk);
  return {(a > 0 ? k.right : k.left) + time * (k.bottom + time * a / 6), k.bottom + time * a / 2, a};
}

void push(const Place& from, double duration, double jerk, PhaseWriter& out) {
  out.push({0, duration, from.distance, from.speed, from.acceleration, jerk, kJerk});
}

void emit_kernel(const Kernel& k, const Bridge& met, const Bridge& left, PhaseWriter& out) {
  if (met.meet < 0 && left.leave > 0 && !k.is_plateau() && k.up_jerk == k.down_jerk) {
    push(on_kernel(k, met.meet), (left.leave - met.meet) / k.up_jerk, k.up_jerk, out);
    return;
  }
  if (met.meet < 0) {
    push(on_kernel(k, met.meet), (std::min(left.leave, 0.0) - met.meet) / k.down_jerk, k.down_jerk, out);
  }
  if (k.is_plateau()) out.push_cruise(met.meet_at, left.leave_at, k.bottom);
  if (left.leave > 0) {
    const double from = std::max(met.meet, 0.0);
    Place at = on_kernel(k, from);
    if (from == 0) at.distance = k.right;
    push(at, (left.leave - from) / k.up_jerk, k.up_jerk, out);
  }
}

/// From the place where the near kernel is left to the place where the far one is met.
class BridgeWriter {
 public:
  BridgeWriter(const Kernel& near, const Kernel& far, const Bridge& b, PhaseWriter& out)
      : near_(near), far_(far), b_(b), out_(out) {}

  void run() {
    const Place start = hold_up();
    turn(start);
    hold_down();
  }

 private:
  Place hold_up() {
    if (!(b_.leave > 0)) {
      Place at = on_kernel(near_, b_.leave);
      if (b_.leave == 0) at.distance = b_.leave_at;
      return at;
    }
    Place at = on_kernel(near_, b_.leave);
    const SpanRamp ramp(near_.up_jerk, b_.limits.up_jerk, b_.limits.up);
    const double hold = ramp.extent(near_.bottom, b_.peak - near_.bottom).hold;
    if (b_.leave < ramp.top || !(hold > 0)) return at;
    push(at, hold, 0.0, out_);
    at.distance += hold * (at.speed + hold * b_.leave / 2);
    at.speed += hold * b_.leave;
    return at;
  }

  /// The acceleration falls from what the near kernel is left with to what the far one is met with.
  void turn(const Place& start) {
    const double up = b_.limits.up_jerk, down = b_.limits.down_jerk;
    const double x = b_.leave, y = b_.meet;
    if (x <= 0 || y >= 0 || up == down) {
      const double jerk = x <= 0 && y < 0 ? down : up;
      push(start, (x - y) / jerk, -jerk, out_);
      return;
    }
    const double time = x / up;
    push(start, time, -up, out_);
    const Place top{start.distance + time * (start.speed + time * x / 3), start.speed + time * x / 2, 0.0};
    push(top, -y / down, -down, out_);
  }

  void hold_down() {
    if (!(b_.meet < 0)) return;
    const SpanRamp ramp(far_.down_jerk, b_.limits.down_jerk, b_.limits.down);
    const double hold = ramp.extent(far_.bottom, b_.peak - far_.bottom).hold;
    if (-b_.meet < ramp.top || !(hold > 0)) return;
    Place at = on_kernel(far_, b_.meet);
    at.distance -= hold * (at.speed - hold * b_.meet / 2);
    at.speed -= hold * b_.meet;
    push(at, hold, 0.0, out_);
  }

  const Kernel& near_;
  const Kernel& far_;
  const Bridge& b_;
  PhaseWriter& out_;
};

}  // namespace

void emit_hull(const std::vector<Kernel>& kernels, const std::vector<HullEntry>& hull, PhaseWriter& out) {
  const Bridge rest;
  for (std::size_t e = 0; e < hull.size(); ++e) {
    const Kernel& k = kernels[hull[e].kernel];
    const Bridge& left = e + 1 < hull.size() ? hull[e + 1].bridge : rest;
    emit_kernel(k, hull[e].bridge, left, out);
    if (e + 1 < hull.size()) BridgeWriter(k, kernels[hull[e + 1].kernel], left, out).run();
  }
}

}  // namespace toolpace::detail
