#include "toolpace/plan/span/mixed_hull.h"

#include <algorithm>
#include <cstddef>

namespace toolpace::detail {
namespace {

/// Bridges that may be made again under smaller limits: per kernel, and in any case.
constexpr std::size_t kUnionsPerKernel = 4, kLeastUnions = 64;
/// Bridges in a row of which each must be made again because of the next.
constexpr std::size_t kDeepest = 2000;
/// Share of its cap that a kernel's bottom keeps.
constexpr double kLeastBottom = 0.5;

class MixedHullBuilder {
 public:
  MixedHullBuilder(const SpeedLimits& limits, const std::vector<SpanBounds>& before, std::vector<Kernel>& kernels,
                   MixedHull& hull)
      : chain_(limits),
        before_(before),
        kernels_(kernels),
        hull_(hull),
        budget_(kUnionsPerKernel * kernels.size() + kLeastUnions) {}

  bool run() {
    hull_.entries.clear();
    hull_.met.clear();
    hull_.entries.reserve(kernels_.size());
    hull_.met.reserve(kernels_.size());
    after_.reserve(kernels_.size());
    push({.meet = kernels_.front().tilt}, 0, {});
    for (std::uint32_t k = 1; k < kernels_.size() && budget_ > 0 && feasible_; ++k) add(k);
    return feasible_ && budget_ > 0 && hull_.entries.back().kernel + 1 == kernels_.size();
  }

 private:
  std::size_t size() const { return hull_.entries.size(); }

  void push(const Bridge& b, std::uint32_t k, const SpanBounds& met) {
    hull_.entries.push_back({b, k});
    hull_.met.push_back(met);
    after_.push_back(own(k));
  }

  /// Limits of a plateau's blocks; points have none.
  SpanBounds own(std::uint32_t k) const {
    SpanBounds bounds;
    if (kernels_[k].is_plateau()) bounds.include(chain_.dynamics_of(kernels_[k].first_node));
    return bounds;
  }

  /// What lies behind the new top may use no more than this.
  void pop(const SpanBounds& bounds) {
    hull_.entries.pop_back();
    hull_.met.pop_back();
    after_.pop_back();
    after_.back().include(bounds);
  }

  const SpanLimits& limits_of(const SpanBounds& bounds) {
    if (!(bounds == last_bounds_)) {
      last_bounds_ = bounds;
      last_limits_ = bounds.limits();
    }
    return last_limits_;
  }

  /// Whether bridges before and behind the kernel meet elsewhere than at its node (on its plateau).
  static bool is_entangled(const Kernel& k, const Bridge& met, const Bridge& left) {
    if (left.kind == BridgeKind::near_is_idle) return true;
    if (k.is_plateau()) return met.meet > 0 || left.leave < 0 || met.meet_at > left.leave_at;
    return met.meet > k.tilt || left.leave < k.tilt;
  }

  /// Whether a tilt, chosen under other limits, still makes a kernel under these.
  static bool suits(const Kernel& under, const SpanLimits& limits) {
    return under.tilt == 0 ||
           (under.tilt <= limits.up.top && -under.tilt <= limits.down.top && under.bottom >= kLeastBottom * under.cap);
  }

  /// Tilts that may be taken away: those of the ends are given.
  bool is_free(std::uint32_t k) const { return kernels_[k].tilt != 0 && k > 0 && k + 1 < kernels_.size(); }

  /// Tilts that do not suit the limits, or put bottoms out of order, go.
  /// @return whether any did
  bool drop_tilts(std::uint32_t k, const SpanLimits& limits) {
    const std::uint32_t top = hull_.entries.back().kernel;
    if (!is_free(k) && !is_free(top)) return false;
    const Kernel near = kernel_under(kernels_[top], limits), far = kernel_under(kernels_[k], limits);
    const bool in_order = near.right <= far.left;
    const bool drops_far = is_free(k) && (!in_order || !suits(far, limits));
    const bool drops_near = is_free(top) && (!in_order || !suits(near, limits));
    if (drops_far) set_tilt(kernels_[k], 0.0, limits);
    if (!drops_near) return drops_far;
    set_tilt(kernels_[top], 0.0, limits);
    const SpanBounds met = hull_.met.back(), after = after_.back();
    pop(met);
    add(top);
    after_.back().include(after);
    return true;
  }

  void add(std::uint32_t k) {
    const SpanBounds around = smaller(own(k), before_[k]);
    while (budget_ > 0) {
      const HullEntry top = hull_.entries.back();
      const SpanBounds under = smaller(after_.back(), around);
      const SpanLimits& limits = limits_of(under);
      if (drop_tilts(k, limits)) continue;
      const Kernel near = kernel_under(kernels_[top.kernel], limits);
      const Bridge b = bridge(near, kernel_under(kernels_[k], limits), limits);
      if (b.kind == BridgeKind::far_is_idle) {
        after_.back() = under;
        return;
      }
      const bool entangled = is_entangled(near, top.bridge, b);
      if (entangled && size() > 1 && !(hull_.met.back() == under)) {
        unite(top.kernel, smaller(hull_.met.back(), under));
      } else if (!entangled || is_in_order(near, top.bridge, b)) {
        push(b, k, under);
        return;
      } else if (size() == 1) {
        feasible_ = false;
        return;
      } else {
        pop(under);
      }
    }
  }

  /// Makes the bridge to the top kernel again, under limits that the one behind it has, too.
  void unite(std::uint32_t top, const SpanBounds& bounds) {
    if (++depth_ > kDeepest) budget_ = 1;
    --budget_;
    pop(bounds);
    add(top);
    after_.back().include(bounds);
    --depth_;
  }

  const SpeedLimits& chain_;
  const std::vector<SpanBounds>& before_;
  std::vector<Kernel>& kernels_;
  MixedHull& hull_;
  std::vector<SpanBounds> after_;  ///< for each entry: limits from it on to the present kernel
  SpanBounds last_bounds_ = {1, 1, 1, 1};
  SpanLimits last_limits_ = SpanBounds{1, 1, 1, 1}.limits();
  std::size_t budget_;
  std::size_t depth_ = 0;
  bool feasible_ = true;
};

/// Stretches of one set of limits in a plateau; 1 for points.
std::size_t count_parts(const SpeedLimits& limits, const Kernel& k) {
  std::size_t parts = 1;
  for (std::uint32_t i = k.first_node + 1; i < k.last_node; ++i) parts += limits.ramp[i] != limits.ramp[i - 1];
  return parts;
}

/// Appends the parts of a plateau.
void part_plateau(const SpanChain& chain, const Kernel& k, std::vector<Kernel>& parts) {
  for (std::uint32_t begin = k.first_node; begin < k.last_node;) {
    std::uint32_t end = begin + 1;
    while (end < k.last_node && chain.limits.ramp[end] == chain.limits.ramp[begin]) ++end;
    Kernel part = k;
    part.first_node = begin;
    part.last_node = end;
    part.left = part.position = chain.position[begin];
    part.right = part.end = chain.position[end];
    parts.push_back(part);
    begin = end;
  }
}

/// Time in which the acceleration rises from one value to another.
double rising_time(double from, double to, const SpanLimits& limits) {
  const double down = std::min(to, 0.0) - std::min(from, 0.0), up = std::max(to, 0.0) - std::max(from, 0.0);
  return down * limits.down.slack + up * limits.up.slack;
}

}  // namespace

void part_by_limits(const SpanChain& chain, std::vector<Kernel>& kernels) {
  std::size_t parts = 0;
  for (const Kernel& k : kernels) parts += count_parts(chain.limits, k);
  if (parts == kernels.size()) return;
  std::vector<Kernel> parted;
  parted.reserve(parts);
  for (const Kernel& k : kernels) {
    if (k.is_plateau()) {
      part_plateau(chain, k, parted);
    } else {
      parted.push_back(k);
    }
  }
  kernels.swap(parted);
}

std::vector<SpanBounds> limits_before(const SpanChain& chain, const std::vector<Kernel>& kernels) {
  std::vector<SpanBounds> before(kernels.size());
  std::size_t block = chain.first;
  for (std::size_t k = 0; k < kernels.size(); ++k) {
    for (; block < kernels[k].first_node; ++block) before[k].include(chain.limits.dynamics_of(block));
    block = kernels[k].last_node;
  }
  return before;
}

bool build_mixed_hull(const SpeedLimits& limits, const std::vector<SpanBounds>& before, std::vector<Kernel>& kernels,
                      MixedHull& hull) {
  return MixedHullBuilder(limits, before, kernels, hull).run();
}

double hull_time(const std::vector<Kernel>& kernels, const MixedHull& hull) {
  double sum = 0.0;
  SpanLimits before = hull.met[1].limits();
  for (std::size_t e = 0; e + 1 < hull.entries.size(); ++e) {
    const Kernel& near = kernels[hull.entries[e].kernel];
    const Kernel& far = kernels[hull.entries[e + 1].kernel];
    const Bridge& met = hull.entries[e].bridge;
    const Bridge& b = hull.entries[e + 1].bridge;
    const SpanLimits after = hull.met[e + 1].limits();
    if (near.is_plateau()) sum += (b.leave_at - met.meet_at) / near.bottom;
    if (e == 0 || hull.met[e] == hull.met[e + 1]) {
      sum += rising_time(met.meet, b.leave, after);
    } else {
      sum += rising_time(met.meet, near.tilt, before) + rising_time(near.tilt, b.leave, after);
    }
    sum += rising_time(b.meet, b.leave, after);
    if (b.leave >= after.up.top) sum += after.up.hold(b.peak - kernel_under(near, after).bottom);
    if (-b.meet >= after.down.top) sum += after.down.hold(b.peak - kernel_under(far, after).bottom);
    before = after;
  }
  return sum;
}

}  // namespace toolpace::detail
