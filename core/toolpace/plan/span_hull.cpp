#include "toolpace/plan/span_hull.h"

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

}  // namespace toolpace::detail
