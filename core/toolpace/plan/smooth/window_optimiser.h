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
    if (!settle(m, kAttempts, monitor)) return false;
    press(m, monitor);
    return true;
  }

  const TubeCheck<D>& check() const { return check_; }

 private:
  /// The barrier's weight falls level by level; with it the motion comes closer to its limits.
  struct Level {
    double weight, edge;
    int rounds;
  };
  static constexpr Level kLevels[] = {{0.1, 0.9, 5}, {0.02, 0.97, 4}, {0.004, 0.995, 4}, {0.0005, 0.999, 5}};
  static constexpr double kShares[] = {0.9999, 0.9995, 0.995, 0.995};  ///< left free for the settling at the end

  /// Aimed at while settling; what lies between them and the limits is room for the steps.
  static constexpr double kSettled[] = {0.9999, 0.9995, 0.997, 0.997};
  static constexpr double kSettledEdge = 0.9998;

  static constexpr int kAttempts = 10, kRounds = 8;  // of settling, a little slower each time; of steps in each
  static constexpr double kSlower = 0.0025;          // first share of slowing down, doubled each time
  static constexpr int kPresses = 2;
  static constexpr double kFaster = 0.001;  // share of pressing

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
  bool settle(MotionWindow<D>& m, int attempts, const Monitor& monitor) {
    for (int attempt = 0; attempt < attempts; ++attempt) {
      Use use;
      for (int i = 0; i <= kRounds; ++i) {
        use = check_.measure(m);
        if (use.is_good()) return true;
        if (monitor.is_cancelled()) return false;
        if (i < kRounds && !settling_step(m)) return false;
      }
      if (attempt + 1 < attempts) slow_down(m, use, kSlower * (1 << attempt));
    }
    return false;
  }

  bool settling_step(MotionWindow<D>& m) {
    RoundOptions o;
    o.weight = 1;
    o.edge = kSettledEdge;
    o.hurry = false;
    std::copy(std::begin(kSettled), std::end(kSettled), o.share);
    if (!round_.solve(m, o)) return false;
    warp_.apply(m, round_.bend, round_.pace);
    passes_.apply(path_, m);
    return true;
  }

  /// Tries whether a slightly shorter duration can be settled too: the barrier stops a little before the limits.
  void press(MotionWindow<D>& m, const Monitor& monitor) {
    double by = kFaster;
    for (int i = 0; i < kPresses && by * static_cast<double>(m.size()) >= 1; ++i) {
      MotionWindow<D> faster = m;
      std::vector<double> pace(m.size());
      for (std::size_t k = 3; k + 3 < m.size(); ++k) pace[k] = by * ease(m, k);
      change_pace(faster, pace);
      if (faster.size() < m.size() && settle(faster, 1, monitor)) {
        m = std::move(faster);
      } else {
        by /= 2;
      }
    }
  }

  void change_pace(MotionWindow<D>& m, const std::vector<double>& pace) {
    const std::vector<typename MotionWindow<D>::Vec> bend(m.size(), MotionWindow<D>::Vec::Zero());
    warp_.apply(m, bend, pace);
    passes_.apply(path_, m);
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
    change_pace(m, pace);
  }

  const TubePath& path_;
  const StepLimits& limits_;
  NewtonRound<D> round_;
  TubeCheck<D> check_;
  Warp<D> warp_;
  PassRefiner<D> passes_;
};

}  // namespace toolpace::tube
