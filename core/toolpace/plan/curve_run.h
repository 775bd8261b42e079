#pragma once
/// A run of blocks whose curves' caps and ramp limits are chosen.

#include <utility>
#include <vector>

#include "toolpace/plan/settle_curves.h"

namespace toolpace::detail {

/// What is chosen of a curve's budget.
struct CurveChoice {
  double share;  ///< of its top speed
  double split;  ///< of the jerk
  bool operator==(const CurveChoice&) const = default;
};

/// Blocks begin … end − 1 of a chain, from rest to rest, under changing choices: what is tried again, or with another split
/// alone, costs next to nothing.
class CurveRun {
 public:
  /// @param memory  shares of each curve that are remembered
  CurveRun(const SpeedLimits& all, std::size_t begin, std::size_t end, const CurveUse& use, std::size_t memory);

  std::size_t blocks() const { return limits_.size(); }
  std::size_t curves() const { return top_.size(); }
  std::size_t block(std::size_t curve) const { return all_.curved[first_ + curve] - begin_; }
  double top(std::size_t curve) const { return top_[curve]; }
  /// What the feed and the widest budget allow.
  double widest_cap(std::size_t curve) const { return all_.block_cap[begin_ + block(curve)]; }
  bool has_jerk() const { return has_jerk_; }

  /// Caps and ramp limits by the choices, one a curve. Nodes keep their own caps: plans see the lower of these and their
  /// neighbours'.
  void apply(const std::vector<CurveChoice>& choices);
  const SpeedLimits& limits() const { return limits_; }
  Cause cause(std::size_t block) const;

 private:
  struct Applied {
    CurveChoice choice;
    double cap;
    Dynamics dynamics;
  };
  Applied make(std::size_t curve, const CurveChoice& choice);
  void put(std::size_t curve);
  const JerkRange& range(std::size_t curve, const CurveBudget& budget, double cap);
  const AlongPath& along(std::size_t curve) const { return all_.along[all_.ceiling[first_ + curve]]; }

  const SpeedLimits& all_;
  std::size_t begin_;
  CurveUse use_;
  SpeedLimits limits_;
  std::size_t first_;                  // of the run's curves
  std::size_t shared_;                 // dynamics of lines; those of the curves stand behind them
  std::vector<double> top_;            // one entry a curve
  std::vector<Applied> now_, before_;  // what stands in the limits, and what stood there before
  std::size_t memory_;
  std::vector<std::pair<double, JerkRange>> range_;  // by cap, `memory_` of each curve
  std::vector<std::uint32_t> oldest_;                // of these
  bool has_jerk_ = false;
};

}  // namespace toolpace::detail
