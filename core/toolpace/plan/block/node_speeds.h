#pragma once
/// Speeds at the nodes where every ramp ends inside its block: backward scan, forward pass, sliding window.

#include <algorithm>
#include <cstddef>
#include <vector>

#include "toolpace/base/monitor.h"
#include "toolpace/law/law.h"
#include "toolpace/limits/speed_limits.h"
#include "toolpace/plan/block/block_profile.h"
#include "toolpace/plan/increasing_root.h"

namespace toolpace::detail {

/// A chain of blocks as the scans see it. Blocks of the program, or spans that merge several of them.
struct Chain {
  const std::vector<double>& length;       ///< [mm]
  const std::vector<std::uint32_t>& ramp;  ///< index into dynamics
  const std::vector<Dynamics>& dynamics;
  const std::vector<MoveTerms>& terms;  ///< one entry for each of the dynamics
  const std::vector<double>& cap;       ///< of the nodes, no higher than either neighbour's feed [mm/s]

  std::size_t size() const { return length.size(); }
  Drive drive(std::size_t block) const { return {dynamics[ramp[block]], terms[ramp[block]]}; }
};

/// Step of the backward scan: the speed at the block's start from which `exit` can be met.
/// @source Ning et al. 2014, section 2, step 2
template <class Law>
double scan_back(double cap, double exit, double length, const Drive& drive) {
  const double least = exit * (1 + kLeastChange);
  // At or below the exit speed the forward pass decides.
  if (cap <= least) return std::min(cap, exit);
  if (ramp_length(cap, exit, drive.terms) <= length) return cap;
  const double entry = std::min(Law::reach(exit, length, drive.limits.down), cap);
  return entry > least ? entry : exit;
}

/// Step of the forward pass: the speed that `entry` can be raised to, no higher than `wanted` ≥ entry.
template <class Law>
double pass_forward(double entry, double wanted, double length, const Drive& drive) {
  const double least = entry * (1 + kLeastChange);
  if (wanted <= least) return entry;
  if (ramp_length(entry, wanted, drive.terms) <= length) return wanted;
  const double exit = std::min(Law::reach(entry, length, drive.limits.up), wanted);
  return exit > least ? exit : entry;
}

/// Largest exit speed below `wanted` < entry that a block allows although `wanted` itself does not fit: jerk-limited
/// ramps get shorter again below a third of their entry speed, and ramps of fixed time get shorter all the way.
/// @return negative where not even a stop fits
inline double drop_below(double entry, double wanted, double length, const MoveTerms& terms) {
  const auto excess = [&](double exit) { return ramp_length(entry, exit, terms) - length; };
  const double at_rest = excess(0.0);
  if (at_rest > length * kFit) return -1.0;
  if (at_rest >= 0) return 0.0;
  return increasing_root(0.0, wanted, at_rest, excess(wanted), excess);
}

/// All blocks at once. Never infeasible: what the scan found for the exit of a block can be met from every speed
/// between that and the scan's entry speed, because a ramp from a lower speed to the same exit is shorter.
template <class Law>
std::vector<double> speeds_of_whole_chain(const Chain& chain) {
  const std::size_t n = chain.size();
  std::vector<double> v(n + 1);
  v[n] = chain.cap[n];
  for (std::size_t i = n; i-- > 0;) v[i] = scan_back<Law>(chain.cap[i], v[i + 1], chain.length[i], chain.drive(i));
  for (std::size_t i = 0; i < n; ++i) {
    if (v[i] < v[i + 1]) v[i + 1] = pass_forward<Law>(v[i], v[i + 1], chain.length[i], chain.drive(i));
  }
  return v;
}

/// A window of N blocks that ends at rest slides by one block at a time (Ning's figures 4 and 5).
///
/// A node speed that was committed under one window's end may leave the next window without a feasible plan, because
/// lengths are not monotone in the far speed. So the plan of the last window is kept whole, and the next one is adopted
/// only if each of its blocks is feasible from the committed speed on. Both scans stop where nothing changes any more,
/// so that a step costs as much as the blocks of one stop, not as N.
template <class Law>
class SlidingWindow {
 public:
  SlidingWindow(const Chain& chain, std::size_t blocks) : chain_(chain), blocks_(blocks) {}

  std::vector<double> run(const Monitor& monitor) {
    const std::size_t n = chain_.size();
    scan_.assign(n + 1, 0.0);
    plan_.assign(n + 1, 0.0);
    candidate_.assign(n + 1, 0.0);
    for (std::size_t end = 1; end <= n; ++end) {
      if ((end & 0xFFFF) == 0 && monitor.is_cancelled()) return {};
      const std::size_t committed = end > blocks_ ? end - blocks_ : 0;
      extend(committed, end);
    }
    return std::move(plan_);
  }

 private:
  /// Moves the window's end to node `end`; the speed at node `committed` stands already.
  void extend(std::size_t committed, std::size_t end) {
    scan_[end] = 0.0;
    std::size_t changed = end;
    for (std::size_t i = end; i-- > committed + 1;) {
      const double v = scan_back<Law>(chain_.cap[i], scan_[i + 1], chain_.length[i], chain_.drive(i));
      if (v == scan_[i]) break;
      scan_[i] = v;
      changed = i;
    }
    const std::size_t from = tail_kept_ ? committed : std::max(committed, changed - 1);
    tail_kept_ = !pass(from, end);
    if (tail_kept_) {
      plan_[end] = 0.0;
    } else {
      std::copy(candidate_.begin() + static_cast<std::ptrdiff_t>(from) + 1,
                candidate_.begin() + static_cast<std::ptrdiff_t>(end) + 1,
                plan_.begin() + static_cast<std::ptrdiff_t>(from) + 1);
    }
  }

  /// Forward pass over nodes from … end into candidate_; false where a block cannot be made.
  bool pass(std::size_t from, std::size_t end) {
    double v = plan_[from];
    for (std::size_t i = from; i < end; ++i) {
      const double wanted = scan_[i + 1];
      const Drive drive = chain_.drive(i);
      if (v <= wanted) {
        v = pass_forward<Law>(v, wanted, chain_.length[i], drive);
      } else if (fits(v, wanted, chain_.length[i], drive.terms)) {
        v = wanted;
      } else {
        v = drop_below(v, wanted, chain_.length[i], drive.terms);
        if (v < 0) return false;
      }
      candidate_[i + 1] = v;
    }
    return true;
  }

  const Chain& chain_;
  std::size_t blocks_;
  std::vector<double> scan_, plan_, candidate_;
  bool tail_kept_ = false;
};

/// Node speeds for a look-ahead of `blocks`; empty when cancelled.
template <class Law>
std::vector<double> node_speeds(const Chain& chain, std::size_t blocks, const Monitor& monitor) {
  if (blocks >= chain.size()) return speeds_of_whole_chain<Law>(chain);
  return SlidingWindow<Law>(chain, blocks).run(monitor);
}

}  // namespace toolpace::detail
