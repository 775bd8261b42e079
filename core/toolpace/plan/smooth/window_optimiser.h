#pragma once
/// One window of motion made as fast as its limits and its tube allow.

#include "toolpace/base/monitor.h"
#include "toolpace/plan/smooth/newton_round.h"
#include "toolpace/plan/smooth/refine_passes.h"
#include "toolpace/plan/smooth/tube_check.h"
#include "toolpace/plan/smooth/warp.h"

namespace toolpace::tube {

template <int D>
class WindowOptimiser {
 public:
  WindowOptimiser(const TubePath& path, const StepLimits& limits)
      : path_(path), limits_(limits), round_(path, limits), check_(path, limits) {}

  /// Improves a window whose start need not keep any limit.
  /// @return true if the result keeps them all; otherwise the window is of no use
  bool improve(MotionWindow<D>& m, const Monitor& monitor) {
    passes_.apply(path_, m);
    for (const Level& level : kLevels) {
      for (int i = 0; i < level.rounds; ++i) {
        if (monitor.is_cancelled()) return false;
        if (!step(m, level)) return false;
        if (i > 0 && round_.mean_pace() < 5e-4 && round_.worst < 1.01) break;
      }
    }
    return settle(m, monitor);
  }

  const TubeCheck<D>& check() const { return check_; }

 private:
  /// The barrier's weight falls level by level; with it the motion comes closer to its limits.
  struct Level {
    double weight, edge;
    int rounds;
  };
  static constexpr Level kLevels[] = {
      {0.1, 0.9, 5}, {0.03, 0.97, 3}, {0.01, 0.99, 4}, {0.004, 0.997, 4}, {0.001, 0.999, 5}};
  static constexpr double kShares[] = {0.999, 0.99, 0.97, 0.96};  ///< left free for the settling at the end

  /// Aimed at while settling; what lies between them and the limits is room for the steps.
  static constexpr double kSettled[] = {0.9985, 0.992, 0.98, 0.98};

  bool step(MotionWindow<D>& m, const Level& level) {
    RoundOptions o;
    o.weight = level.weight;
    o.edge = level.edge;
    std::copy(std::begin(kShares), std::end(kShares), o.share);
    if (!round_.solve(m, o)) return false;
    warp_.apply(m, round_.bend, round_.pace);
    passes_.apply(path_, m);
    return true;
  }

  /// At fixed duration, to a motion that keeps every limit; where that fails, a little slower there, and again.
  bool settle(MotionWindow<D>& m, const Monitor& monitor) {
    constexpr int kAttempts = 8, kRounds = 8;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      Use use;
      for (int i = 0; i <= kRounds; ++i) {
        use = check_.measure(m);
        if (use.is_good()) return true;
        if (monitor.is_cancelled()) return false;
        if (i == kRounds) break;
        RoundOptions o;
        o.weight = 1;
        o.edge = 0.999;
        o.hurry = false;
        std::copy(std::begin(kSettled), std::end(kSettled), o.share);
        if (!round_.solve(m, o)) return false;
        warp_.apply(m, round_.bend, round_.pace);
        passes_.apply(path_, m);
      }
      slow_down(m, use, 0.01 * (1 << attempt));
    }
    return false;
  }

  /// Slows down by the share `by` around what is over, fading out smoothly.
  void slow_down(MotionWindow<D>& m, const Use& use, double by) {
    const std::size_t n = m.size();
    constexpr std::size_t kReach = 60;
    std::vector<double> free(n, 1.0), low;
    for (const std::size_t at : use.over) free[std::min(at + 1, n - 1)] = 0;
    smooth_minimum(free, kReach, low);
    std::vector<double> pace(n);
    for (std::size_t k = 0; k < n; ++k) pace[k] = k < 3 || k + 3 >= n ? 0 : -by * (1 - free[k]) * ease(m, k);
    const std::vector<typename MotionWindow<D>::Vec> bend(n, MotionWindow<D>::Vec::Zero());
    warp_.apply(m, bend, pace);
    passes_.apply(path_, m);
  }

  const TubePath& path_;
  const StepLimits& limits_;
  NewtonRound<D> round_;
  TubeCheck<D> check_;
  Warp<D> warp_;
  PassRefiner<D> passes_;
};

}  // namespace toolpace::tube
