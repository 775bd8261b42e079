#include "toolpace/plan/span_hull.h"

#include "toolpace/plan/span_ramp.h"

namespace toolpace::detail {
namespace {

/// Whether the kernel is left no earlier than it is met.
bool is_in_order(const Kernel& k, const HullEntry& met, const Bridge& left) {
  if (!k.is_plateau()) return met.bridge.meet <= left.leave;
  if (met.bridge.meet_at != left.leave_at) return met.bridge.meet_at < left.leave_at;
  return met.bridge.meet <= left.leave;
}

class HullBuilder {
 public:
  HullBuilder(const std::vector<Kernel>& kernels, const SpanLimits* uniform, std::vector<HullEntry>& hull)
      : kernels_(kernels), uniform_(uniform), hull_(hull) {}

  void run() {
    hull_.clear();
    links_.clear();
    hull_.push_back({0, {}});
    if (uniform_ == nullptr) links_.push_back({});
    for (std::uint32_t k = 1; k < kernels_.size(); ++k) add(k);
  }

  /// Only without links, that is with limits that hold everywhere.
  void run_again(const std::vector<std::uint32_t>& changed, const std::vector<HullEntry>& old) {
    hull_.clear();
    std::size_t next = 0;
    for (std::size_t c = 0; c < changed.size();) {
      // Up to here nothing is different.
      while (next < old.size() && old[next].kernel < changed[c]) hull_.push_back(old[next++]);
      std::uint32_t k = hull_.back().kernel + 1;
      for (; k < kernels_.size(); ++k) {
        add(k);
        while (c < changed.size() && changed[c] <= k) ++c;
        while (next < old.size() && old[next].kernel < k) ++next;
        // A kernel that is reached from a kernel as before is what the old hull went on from too.
        const bool joined = next < old.size() && old[next].kernel == k && hull_.back().kernel == k && next > 0 &&
                            hull_[hull_.size() - 2].kernel == old[next - 1].kernel &&
                            hull_.back().bridge.meet == old[next].bridge.meet &&
                            hull_.back().bridge.meet_at == old[next].bridge.meet_at;
        if (joined && (c == changed.size() || changed[c] > k)) break;
      }
      ++next;
    }
    while (next < old.size()) hull_.push_back(old[next++]);
  }

 private:
  void add(std::uint32_t k) {
    if (uniform_ == nullptr) since_.include(kernels_[k].before);
    for (;;) {
      const HullEntry& top = hull_.back();
      const Bridge b = bridge(kernels_[top.kernel], kernels_[k], limits_to(k));
      if (b.kind == BridgeKind::far_is_idle) {
        if (uniform_ == nullptr) since_.include(kernels_[k].own);
        return;
      }
      const bool leaves_in_time = b.kind != BridgeKind::near_is_idle && is_in_order(kernels_[top.kernel], top, b);
      // The start is at rest: every bridge can leave it.
      if (leaves_in_time || hull_.size() == 1) {
        push(k, b);
        return;
      }
      pop();
    }
  }

  SpanLimits limits_to(std::uint32_t k) const {
    if (uniform_ != nullptr) return *uniform_;
    SpanLimits limits = since_;
    limits.include(kernels_[hull_.back().kernel].own);
    limits.include(kernels_[k].own);
    return limits;
  }

  void push(std::uint32_t k, const Bridge& b) {
    hull_.push_back({k, b});
    if (uniform_ != nullptr) return;
    links_.push_back(since_);
    since_ = SpanLimits{};
  }

  void pop() {
    if (uniform_ == nullptr) {
      since_.include(kernels_[hull_.back().kernel].own);
      since_.include(links_.back());
      links_.pop_back();
    }
    hull_.pop_back();
  }

  const std::vector<Kernel>& kernels_;
  const SpanLimits* uniform_;
  std::vector<HullEntry>& hull_;
  std::vector<SpanLimits> links_;  ///< smallest limits between each entry and the one before it
  SpanLimits since_;               ///< smallest limits behind the last entry
};

}  // namespace

void build_hull(const std::vector<Kernel>& kernels, const SpanLimits* uniform, std::vector<HullEntry>& hull) {
  HullBuilder(kernels, uniform, hull).run();
}

void rebuild_hull(const std::vector<Kernel>& kernels, const SpanLimits& limits,
                  const std::vector<std::uint32_t>& changed, std::vector<HullEntry>& hull) {
  std::vector<HullEntry> fresh;
  fresh.reserve(hull.size() + 16);
  HullBuilder(kernels, &limits, fresh).run_again(changed, hull);
  hull.swap(fresh);
}

double hull_time(const std::vector<Kernel>& kernels, const std::vector<HullEntry>& hull) {
  double sum = 0.0;
  for (std::size_t e = 0; e + 1 < hull.size(); ++e) {
    const Kernel& near = kernels[hull[e].kernel];
    const Kernel& far = kernels[hull[e + 1].kernel];
    const Bridge& b = hull[e + 1].bridge;
    const double x = b.leave, y = b.meet;
    if (near.is_plateau()) sum += (b.leave_at - hull[e].bridge.meet_at) / near.bottom;
    sum += (x > 0 ? x / near.up_jerk + x / b.limits.up_jerk : x / near.down_jerk + x / b.limits.down_jerk);
    sum -= (y > 0 ? y / far.up_jerk + y / b.limits.up_jerk : y / far.down_jerk + y / b.limits.down_jerk);
    if (x >= b.limits.up)
      sum += SpanRamp(near.up_jerk, b.limits.up_jerk, x).extent(near.bottom, b.peak - near.bottom).hold;
    if (-y >= b.limits.down)
      sum += SpanRamp(far.down_jerk, b.limits.down_jerk, -y).extent(far.bottom, b.peak - far.bottom).hold;
  }
  return sum;
}

}  // namespace toolpace::detail
