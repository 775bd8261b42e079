#pragma once
/// A short sequence of phases without heap.

#include <algorithm>
#include <cstddef>
#include <span>
#include <stdexcept>

#include "toolpace/law/phase.h"

namespace toolpace {

/// The phases of one move: at most two ramps of three phases and a cruise.
class PhaseList {
 public:
  static constexpr std::size_t kCapacity = 7;

  PhaseList() noexcept {}  // leaves the places empty: a move fills three of seven on average
  PhaseList(const PhaseList& other) noexcept : count_(other.count_) { std::copy_n(other.phases_, count_, phases_); }
  PhaseList& operator=(const PhaseList& other) noexcept {
    count_ = other.count_;
    std::copy_n(other.phases_, count_, phases_);
    return *this;
  }

  /// Throws std::length_error when full: no law has that many phases.
  void push_back(const Phase& phase) {
    if (count_ == kCapacity) throw std::length_error("a move has more phases than two ramps and a cruise");
    phases_[count_++] = phase;
  }
  bool empty() const { return count_ == 0; }
  std::size_t size() const { return count_; }
  const Phase& operator[](std::size_t i) const { return phases_[i]; }
  const Phase& front() const { return phases_[0]; }
  const Phase& back() const { return phases_[count_ - 1]; }
  const Phase* begin() const { return phases_; }
  const Phase* end() const { return phases_ + count_; }
  std::span<const Phase> span() const { return {begin(), count_}; }

 private:
  std::size_t count_ = 0;
  union {
    Phase phases_[kCapacity];
  };
};

}  // namespace toolpace
