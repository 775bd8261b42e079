#pragma once
/// A short sequence of phases without heap.

#include <array>
#include <cstddef>
#include <span>

#include "toolpace/law/phase.h"

namespace toolpace {

/// The phases of one move: at most two ramps of three phases and a cruise.
class PhaseList {
 public:
  static constexpr std::size_t kCapacity = 7;

  void push_back(const Phase& phase) { phases_.at(count_++) = phase; }
  bool empty() const { return count_ == 0; }
  std::size_t size() const { return count_; }
  const Phase& operator[](std::size_t i) const { return phases_[i]; }
  const Phase& front() const { return phases_[0]; }
  const Phase& back() const { return phases_[count_ - 1]; }
  const Phase* begin() const { return phases_.data(); }
  const Phase* end() const { return phases_.data() + count_; }
  std::span<const Phase> span() const { return {begin(), count_}; }

 private:
  std::array<Phase, kCapacity> phases_;
  std::size_t count_ = 0;
};

}  // namespace toolpace
