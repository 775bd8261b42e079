#pragma once
/// Ramp limits of many blocks, each different one kept once.

#include <array>
#include <cstdint>
#include <vector>

#include "toolpace/limits/ramp_limits.h"
#include "toolpace/limits/speed_limits.h"

namespace toolpace {

/// Gathers the ramp limits of a chain. A program of few directions has few of them, and all are found again; one of curved
/// surfaces has another for nearly every block, where looking for more than the first few hundred would gain nothing: from there on
/// each is compared with those and with the last.
class DynamicsTable {
 public:
  /// Where these, set by this cause, stand in the list, in which they are put unless they are known.
  std::uint32_t add(const Dynamics& dynamics, Cause cause);

  /// Gives the list and its causes away.
  void give_to(SpeedLimits& limits) &&;

 private:
  static constexpr std::size_t kSlots = 1024, kMostFound = kSlots / 2;

  bool is_at(std::uint32_t place, const Dynamics& dynamics, Cause cause) const {
    return list_[place] == dynamics && cause_[place] == cause;
  }

  std::vector<Dynamics> list_;
  std::vector<Cause> cause_;
  std::uint32_t last_ = 0;
  std::array<std::uint32_t, kSlots> slot_ = {};  ///< place in the list + 1, found by hash; 0 = free
};

}  // namespace toolpace
