#include "toolpace/plan/span_mixed_hull.h"

#include <cstddef>
#include <limits>

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
  MixedHullBuilder(std::vector<Kernel>& kernels, const KernelBounds& bounds, MixedHull& hull)
      : kernels_(kernels), bounds_(bounds), hull_(hull), budget_(kUnionsPerKernel * kernels.size() + kLeastUnions) {}

  bool run() {
    hull_.entries.clear();
    hull_.met.clear();
    push({}, 0, {});
    for (std::uint32_t k = 1; k < kernels_.size() && budget_ > 0 && feasible_; ++k) add(k);
    return feasible_ && budget_ > 0 && hull_.entries.back().kernel + 1 == kernels_.size();
  }

 private:
  std::size_t size() const { return hull_.entries.size(); }

  void push(const Bridge& b, std::uint32_t k, const SpanBounds& met) {
    hull_.entries.push_back({b, k});
    hull_.met.push_back(met);
    after_.push_back(bounds_.own[k]);
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

  /// Tilts that do not suit the limits, or put bottoms out of order, go.
  /// @return whether any did
  bool drop_tilts(std::uint32_t k, const SpanLimits& limits) {
    const std::uint32_t top = hull_.entries.back().kernel;
    if (kernels_[k].tilt == 0 && kernels_[top].tilt == 0) return false;
    const Kernel near = kernel_under(kernels_[top], limits), far = kernel_under(kernels_[k], limits);
    const bool in_order = near.right <= far.left, near_suits = suits(near, limits);
    if (in_order && near_suits && suits(far, limits)) return false;
    if (far.tilt != 0 && (!in_order || !suits(far, limits))) set_tilt(kernels_[k], 0.0, limits);
    if (near.tilt == 0 || (in_order && near_suits)) return true;
    set_tilt(kernels_[top], 0.0, limits);
    const SpanBounds met = hull_.met.back(), after = after_.back();
    pop(met);
    add(top);
    after_.back().include(after);
    return true;
  }

  void add(std::uint32_t k) {
    SpanBounds around = bounds_.own[k];
    around.include(bounds_.before[k]);
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

  std::vector<Kernel>& kernels_;
  const KernelBounds& bounds_;
  MixedHull& hull_;
  std::vector<SpanBounds> after_;  ///< for each entry: limits from it on to the present kernel
  SpanBounds last_bounds_ = {1, 1, 1, 1};
  SpanLimits last_limits_ = SpanBounds{1, 1, 1, 1}.limits();
  std::size_t budget_;
  std::size_t depth_ = 0;
  bool feasible_ = true;
};

}  // namespace

void part_by_limits(const SpanChain& chain, std::vector<Kernel>& kernels, KernelBounds& bounds) {
  std::vector<Kernel> parted;
  parted.reserve(kernels.size());
  bounds.before.clear();
  bounds.own.clear();
  std::size_t block = chain.first;
  const auto include_upto = [&](std::size_t node, SpanBounds& all) {
    for (; block < node; ++block) all.include(chain.limits.dynamics_of(block));
  };
  for (const Kernel& k : kernels) {
    SpanBounds before;
    include_upto(k.first_node, before);
    do {
      Kernel part = k;
      SpanBounds own;
      if (k.is_plateau()) {
        std::size_t end = block + 1;
        while (end < k.last_node && chain.limits.ramp[end] == chain.limits.ramp[block]) ++end;
        part.first_node = static_cast<std::uint32_t>(block);
        part.last_node = static_cast<std::uint32_t>(end);
        part.left = part.position = chain.position[block];
        part.right = part.end = chain.position[end];
        include_upto(end, own);
      }
      parted.push_back(part);
      bounds.before.push_back(before);
      bounds.own.push_back(own);
      before = {};
    } while (block < k.last_node);
  }
  kernels.swap(parted);
}

bool build_mixed_hull(std::vector<Kernel>& kernels, const KernelBounds& bounds, MixedHull& hull) {
  return MixedHullBuilder(kernels, bounds, hull).run();
}

}  // namespace toolpace::detail
