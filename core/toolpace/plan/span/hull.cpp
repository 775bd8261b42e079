#include "toolpace/plan/span/hull.h"

namespace toolpace::detail {
namespace {

class HullBuilder {
 public:
  HullBuilder(const std::vector<Kernel>& kernels, const SpanLimits& limits, std::vector<HullEntry>& hull)
      : kernels_(kernels), limits_(limits), hull_(hull) {
    hull_.clear();
  }

  bool run() {
    hull_.push_back({{.meet = kernels_.front().tilt}, 0});
    for (std::uint32_t k = 1; k < kernels_.size(); ++k) add(k);
    return is_whole();
  }

  bool run_again(const std::vector<std::uint32_t>& changed, const std::vector<HullEntry>& old) {
    std::size_t next = 0;
    for (std::size_t c = 0; c < changed.size();) {
      // Up to here nothing is different.
      while (next < old.size() && old[next].kernel < changed[c]) hull_.push_back(old[next++]);
      for (std::uint32_t k = hull_.back().kernel + 1; k < kernels_.size(); ++k) {
        add(k);
        while (c < changed.size() && changed[c] <= k) ++c;
        while (next < old.size() && old[next].kernel < k) ++next;
        if (has_joined(k, old, next) && (c == changed.size() || changed[c] > k)) break;
      }
      ++next;
    }
    while (next < old.size()) hull_.push_back(old[next++]);
    return is_whole();
  }

 private:
  /// A kernel that is met as before, and from the same kernel, is what the old hull went on from too.
  bool has_joined(std::uint32_t k, const std::vector<HullEntry>& old, std::size_t next) const {
    return next > 0 && next < old.size() && old[next].kernel == k && hull_.back().kernel == k &&
           hull_[hull_.size() - 2].kernel == old[next - 1].kernel &&
           hull_.back().bridge.meet == old[next].bridge.meet && hull_.back().bridge.meet_at == old[next].bridge.meet_at;
  }

  void add(std::uint32_t k) {
    for (;;) {
      const HullEntry& top = hull_.back();
      const Bridge b = bridge(kernels_[top.kernel], kernels_[k], limits_);
      if (b.kind == BridgeKind::far_is_idle) return;
      const bool leaves_in_time = is_in_order(kernels_[top.kernel], top.bridge, b);
      if (leaves_in_time || hull_.size() == 1) {
        feasible_ = feasible_ && leaves_in_time;
        hull_.push_back({b, k});
        return;
      }
      hull_.pop_back();
    }
  }

  bool is_whole() const {
    return feasible_ && hull_.back().kernel + 1 == kernels_.size() && hull_.back().bridge.meet <= kernels_.back().tilt;
  }

  const std::vector<Kernel>& kernels_;
  const SpanLimits& limits_;
  std::vector<HullEntry>& hull_;
  bool feasible_ = true;
};

}  // namespace

bool build_hull(const std::vector<Kernel>& kernels, const SpanLimits& limits, std::vector<HullEntry>& hull) {
  return HullBuilder(kernels, limits, hull).run();
}

bool rebuild_hull(const std::vector<Kernel>& kernels, const SpanLimits& limits,
                  const std::vector<std::uint32_t>& changed, std::vector<HullEntry>& hull) {
  std::vector<HullEntry> fresh;
  fresh.reserve(hull.size() + 16);
  const bool whole = HullBuilder(kernels, limits, fresh).run_again(changed, hull);
  hull.swap(fresh);
  return whole;
}

double hull_time(const std::vector<Kernel>& kernels, const SpanLimits& limits, const std::vector<HullEntry>& hull) {
  // A turn has its acceleration already, and keeps it.
  double sum = kernels.back().tilt * limits.down.slack - kernels.front().tilt * limits.up.slack;
  for (std::size_t e = 0; e + 1 < hull.size(); ++e) {
    const Kernel& near = kernels[hull[e].kernel];
    const Kernel& far = kernels[hull[e + 1].kernel];
    const Bridge& b = hull[e + 1].bridge;
    if (near.is_plateau()) sum += (b.leave_at - hull[e].bridge.meet_at) / near.bottom;
    // Each acceleration is built up and taken away once at full jerk.
    sum += 2 * b.leave * (b.leave > 0 ? limits.up.slack : limits.down.slack);
    sum -= 2 * b.meet * (b.meet > 0 ? limits.up.slack : limits.down.slack);
    if (b.leave >= limits.up.top) sum += limits.up.hold(b.peak - near.bottom);
    if (-b.meet >= limits.down.top) sum += limits.down.hold(b.peak - far.bottom);
  }
  return sum;
}

}  // namespace toolpace::detail
