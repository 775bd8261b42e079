#include "toolpace/limits/dynamics_table.h"

#include <bit>
#include <utility>

namespace toolpace {
namespace {

std::uint64_t hash_of(const Dynamics& d) {
  constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15;  // 2^64 over the golden ratio
  std::uint64_t hash = 0;
  for (const double value : {d.up.acceleration, d.up.jerk, d.up.time, d.down.acceleration, d.down.jerk, d.down.time}) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * kOdd;
    hash ^= hash >> 32;
  }
  return hash;
}

}  // namespace

std::uint32_t DynamicsTable::add(const Dynamics& dynamics, Cause cause) {
  if (!list_.empty() && is_at(last_, dynamics, cause)) return last_;
  for (std::size_t at = hash_of(dynamics) % kSlots;; at = (at + 1) % kSlots) {
    if (slot_[at] == 0) {
      last_ = static_cast<std::uint32_t>(list_.size());
      list_.push_back(dynamics);
      cause_.push_back(cause);
      if (list_.size() <= kMostFound) slot_[at] = last_ + 1;
      return last_;
    }
    if (is_at(slot_[at] - 1, dynamics, cause)) return last_ = slot_[at] - 1;
  }
}

void DynamicsTable::give_to(SpeedLimits& limits) && {
  if (list_.size() > kMostFound) {
    list_.shrink_to_fit();
    cause_.shrink_to_fit();
  }
  limits.dynamics = std::move(list_);
  limits.dynamics_cause = std::move(cause_);
}

}  // namespace toolpace
