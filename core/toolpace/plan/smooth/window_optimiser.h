#pragma once
/// One window of motion made as fast as its limits and its tube allow.

#include "toolpace/base/monitor.h"
#include "toolpace/plan/smooth/newton_round.h"
#include "toolpace/plan/smooth/refine_passes.h"
#include "toolpace/plan/smooth/tube_check.h"
#include "toolpace/plan/smooth/warp.h"

namespace toolpace::detail::tube {

template <int D>
class WindowOptimiser {
 public:
  using Vec = Eigen::Matrix<double, D, 1>;
  WindowOptimiser(const TubePath& path, const StepLimits& limits)
      : path_(path), limits_(limits), round_(path, limits), check_(path, limits) {}

  /// Improves a window whose start need not keep any limit.
  /// @return true if the result keeps them all; otherwise the window is of no use
  bool improve(MotionWindow<D>& m, const Monitor& monitor) {
    passes_.apply(path_, m);
    round_.begin(m);
    for (const Level& level : kLevels) {
      if (!hurry(m, level, monitor)) return false;
    }
    if (!settle(m, kAttempts, monitor)) return false;
    press(m, monitor);
    return true;
  }

  const TubeCheck<D>& check() const { return check_; }

 private:
  /// The weight of the limits against time falls level by level; with it the motion comes closer to its limits.
  struct Level {
    double weight;
    int rounds;  ///< at most: a level is left once a round gains too little
  };
  static constexpr Level kLevels[] = {{0.1, 20}, {0.03, 2}, {0.01, 2}, {0.003, 2}, {0.001, 20}, {0.0003, 5}};
  static constexpr double kGain = 0.003;  ///< share of the duration
  static constexpr double kSettlingWeight = 0.0005;

  static constexpr int kAttempts = 10, kRounds = 14;  // of settling, a little slower each time; of steps in each
  static constexpr double kSlower = 0.0025;           // first share of slowing down, doubled each time
  static constexpr int kPresses = 2;
  static constexpr double kFaster = 0.001;  // share of pressing

  /// Rounds of bending and retiming.
  bool hurry(MotionWindow<D>& m, const Level& level, const Monitor& monitor) {
    for (int i = 0; i < level.rounds; ++i) {
      if (monitor.is_cancelled()) return false;
      const auto before = static_cast<double>(m.size());
      if (!step(m, {level.weight, true, {0.9999, 0.9995, 0.995, 0.995}})) return false;
      if (i > 0 && before - static_cast<double>(m.size()) < kGain * before) break;
    }
    return true;
  }

  bool step(MotionWindow<D>& m, const RoundOptions& options) {
    if (!round_.solve(m, options)) return false;
    apply(m, round_.bend, round_.pace);
    return true;
  }

  void apply(MotionWindow<D>& m, const std::vector<Vec>& bend, const std::vector<double>& pace) {
    warp_.apply(m, bend, pace);
    if (!warp_.was().empty()) round_.multipliers.move(warp_.was());
    passes_.apply(path_, m);
  }

  /// At fixed duration, to a motion that keeps every limit; where that fails, a little slower there, and again.
  bool settle(MotionWindow<D>& m, int attempts, const Monitor& monitor) {
    for (int attempt = 0; attempt < attempts; ++attempt) {
      Use use;
      for (int i = 0; i <= kRounds; ++i) {
        use = check_.measure(m);
        if (use.is_good()) return true;
        if (monitor.is_cancelled()) return false;
        if (i < kRounds && !step(m, {kSettlingWeight, false, {0.9999, 0.9995, 0.997, 0.997}})) return false;
      }
      if (attempt + 1 < attempts) slow_down(m, use, kSlower * (1 << attempt));
    }
    return false;
  }

  /// Tries whether a slightly shorter duration can be settled too: the weight of the limits keeps a little away from them.
  void press(MotionWindow<D>& m, const Monitor& monitor) {
    double by = kFaster;
    for (int i = 0; i < kPresses && by * static_cast<double>(m.size()) >= 1; ++i) {
      MotionWindow<D> faster = m;
      const Multipliers<D> before = round_.multipliers;
      std::vector<double> pace(m.size());
      for (std::size_t k = 3; k + 3 < m.size(); ++k) pace[k] = by * ease(m, k);
      change_pace(faster, pace);
      if (faster.size() < m.size() && settle(faster, 1, monitor)) {
        m = std::move(faster);
      } else {
        round_.multipliers = before;
        by /= 2;
      }
    }
  }

  void change_pace(MotionWindow<D>& m, const std::vector<double>& pace) {
    const std::vector<Vec> bend(m.size(), Vec::Zero());
    apply(m, bend, pace);
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

}  // namespace toolpace::detail::tube
