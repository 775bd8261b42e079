#include "toolpace/plan/span/emit.h"

#include <algorithm>

namespace toolpace::detail {
namespace {

constexpr PhaseShape kJerk = PhaseShape::constant_jerk;

struct Place {
  double distance;  ///< from the node that the writer counts from [mm]
  double speed, acceleration;
};

class HullWriter {
 public:
  HullWriter(const SpanLimits& limits, PhaseWriter& out) : up_(limits.up), down_(limits.down), out_(out) {}

  void write_kernel(const Kernel& k, const Bridge& met, const Bridge& left) {
    if (met.meet < 0 && left.leave > 0 && !k.is_plateau() && up_.jerk == down_.jerk) {
      push(place(k, met.meet), (left.leave - met.meet) * up_.slack, up_.jerk);
      return;
    }
    write_falling(k, met.meet, left.leave);
    write_bottom(k, met, left);
    write_rising(k, met.meet, left.leave);
  }

  void write_bottom(const Kernel& k, const Bridge& met, const Bridge& left) {
    if (!k.is_plateau()) return;
    out_.count_from(k.first_node);
    out_.push_cruise(met.meet_at - k.position, left.leave_at - k.position, k.bottom);
  }

  /// Runs along the kernel from one acceleration to a larger one; the negative part, and the positive one.
  void write_falling(const Kernel& k, double from, double to) {
    if (from < 0) push(place(k, from), (std::min(to, 0.0) - from) * down_.slack, down_.jerk);
  }

  void write_rising(const Kernel& k, double from, double to) {
    if (!(to > 0)) return;
    const double begin = std::max(from, 0.0);
    push(place(k, begin), (to - begin) * up_.slack, up_.jerk);
  }

  void write_bridge(const Kernel& near, const Kernel& far, const Bridge& b) {
    turn(b, hold_up(near, b));
    hold_down(far, b);
  }

 private:
  void push(const Place& from, double duration, double jerk) {
    out_.push({0, duration, from.distance, from.speed, from.acceleration, jerk, kJerk});
  }

  /// Place on the kernel where the acceleration is `a`; for 0 the right end of its bottom. Goes on from the node that is
  /// nearest.
  Place place(const Kernel& k, double a) {
    const double time = a * (a < 0 ? down_.slack : up_.slack);
    out_.count_from(a < 0 ? k.first_node : k.last_node);
    const double bottom = a < 0 ? k.left - k.position : k.right - k.end;
    return {bottom + time * (k.bottom + time * a / 6), k.bottom + time * a / 2, a};
  }

  /// @return where the acceleration begins to fall
  Place hold_up(const Kernel& near, const Bridge& b) {
    Place at = place(near, b.leave);
    if (b.leave == 0) at.distance = b.leave_at - near.end;
    if (b.leave < up_.top) return at;
    const double hold = up_.hold(b.peak - near.bottom);
    push(at, hold, 0.0);
    if (hold > 0) {
      at.distance += hold * (at.speed + hold * b.leave / 2);
      at.speed += hold * b.leave;
    }
    return at;
  }

  /// The acceleration falls from what the near kernel is left with to what the far one is met with.
  void turn(const Bridge& b, const Place& start) {
    const double x = b.leave, y = b.meet;
    if (x <= 0 || y >= 0 || up_.jerk == down_.jerk) {
      const SpanRamp& side = x <= 0 && y < 0 ? down_ : up_;
      push(start, (x - y) * side.slack, -side.jerk);
      return;
    }
    const double time = x * up_.slack;
    push(start, time, -up_.jerk);
    const Place top{start.distance + time * (start.speed + time * x / 3), start.speed + time * x / 2, 0.0};
    push(top, -y * down_.slack, -down_.jerk);
  }

  void hold_down(const Kernel& far, const Bridge& b) {
    if (-b.meet < down_.top) return;
    const double hold = down_.hold(b.peak - far.bottom);
    if (!(hold > 0)) return;
    Place at = place(far, b.meet);
    at.distance -= hold * (at.speed - hold * b.meet / 2);
    at.speed -= hold * b.meet;
    push(at, hold, 0.0);
  }

  const SpanRamp& up_;
  const SpanRamp& down_;
  PhaseWriter& out_;
};

}  // namespace

void emit_hull(const std::vector<Kernel>& kernels, const SpanLimits& limits, const std::vector<HullEntry>& hull,
               PhaseWriter& out) {
  const Bridge rest{.leave = kernels.back().tilt};
  HullWriter writer(limits, out);
  for (std::size_t e = 0; e < hull.size(); ++e) {
    const Kernel& k = kernels[hull[e].kernel];
    const Bridge& left = e + 1 < hull.size() ? hull[e + 1].bridge : rest;
    writer.write_kernel(k, hull[e].bridge, left);
    if (e + 1 < hull.size()) writer.write_bridge(k, kernels[hull[e + 1].kernel], left);
  }
}

void emit_hull(const std::vector<Kernel>& kernels, const MixedHull& hull, PhaseWriter& out) {
  const Bridge rest{.leave = kernels.back().tilt};
  for (std::size_t e = 0; e < hull.entries.size(); ++e) {
    const Kernel& k = kernels[hull.entries[e].kernel];
    const bool is_last = e + 1 == hull.entries.size();
    const Bridge& met = hull.entries[e].bridge;
    const Bridge& left = is_last ? rest : hull.entries[e + 1].bridge;
    const SpanLimits before = (e > 0 ? hull.met[e] : hull.met[1]).limits();
    const SpanLimits after = (is_last ? hull.met[e] : hull.met[e + 1]).limits();
    const Kernel arrived = kernel_under(k, before), departed = kernel_under(k, after);
    HullWriter arrival(before, out), departure(after, out);
    if (is_last || (e > 0 && hull.met[e] == hull.met[e + 1])) {
      arrival.write_kernel(arrived, met, left);
    } else {
      // Met before the node, left behind it: at the node itself the acceleration is the tilt.
      arrival.write_falling(arrived, met.meet, k.tilt);
      arrival.write_rising(arrived, met.meet, k.tilt);
      departure.write_falling(departed, k.tilt, left.leave);
      departure.write_bottom(k, met, left);
      departure.write_rising(departed, k.tilt, left.leave);
    }
    if (!is_last) {
      departure.write_bridge(departed, kernel_under(kernels[hull.entries[e + 1].kernel], after), left);
    }
  }
}

}  // namespace toolpace::detail
