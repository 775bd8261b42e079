#pragma once
/// One window of motion made as fast as its limits and its tube allow.

#include "toolpace/plan/smooth/coarse_motion.h"
#include "toolpace/plan/smooth/window_settler.h"

namespace toolpace::detail::tube {

template <int D>
class WindowOptimiser {
 public:
  WindowOptimiser(const TubePath& path, const StepLimits& limits)
      : path_(path),
        limits_(limits),
        longer_{coarser(limits, 2), coarser(limits, 4)},
        round_(path),
        settler_(path, limits) {}

  /// Improves a window whose start need not keep any limit.
  /// @return true if the result keeps them all; otherwise the window is of no use
  bool improve(MotionWindow<D>& m, const Monitor& monitor) {
    if (m.size() < kLeastOnLonger) return run(m, monitor);
    if (limits_.effort == TubeEffort::quick) {
      m = coarsened(m, kQuickLongest);
      return run(m, monitor);
    }
    MotionWindow<D> start = m;
    m = coarsened(m, kLongest);
    const bool is_sound = run(m, monitor);
    if (monitor.is_cancelled()) return false;
    if (is_sound && (!settler_.has_slowed() || start.size() > kMostTwice)) return true;
    // Long steps may have led it astray.
    if (run(start, monitor) && (!is_sound || start.size() < m.size())) {
      m = std::move(start);
      return true;
    }
    return is_sound;
  }

  const TubeCheck<D>& check() const { return settler_.check(); }

 private:
  bool run(MotionWindow<D>& m, const Monitor& monitor) {
    passes_.apply(path_, m);
    round_.begin(m, limits(m));
    for (const Level& level : levels()) {
      while (m.stride > level.stride) {
        m = halved(m);
        round_.go_on(m, limits(m));
      }
      if (!hurry(m, level, monitor)) return false;
    }
    return settler_.apply(m, round_.multipliers, monitor);
  }

  /// The weight of the limits against time falls level by level; with it the motion comes closer to its limits. The first
  /// levels, which have the longest way to go, do it on few, long steps.
  struct Level {
    double weight;
    int rounds;  ///< at most: a level is left once a round gains too little
    std::size_t stride;
  };
  static constexpr Level kLevels[] = {{0.1, 20, 4},  {0.03, 2, 2},   {0.03, 2, 1},  {0.01, 2, 1},
                                      {0.003, 2, 1}, {0.001, 20, 1}, {0.0003, 5, 1}};
  static constexpr Level kQuickLevels[] = {{0.01, 2, 1},
                                           {0.002, 1, 1}};       // after rounds that depend on the path's length
  static constexpr std::size_t kLongest = 4, kQuickLongest = 2;  // steps in one, at first
  static constexpr std::size_t kLeastOnLonger = 60;              // control points
  static constexpr std::size_t kMostTwice = 2000;  // control points of a first motion that may be planned twice
  static constexpr double kGain = 0.003;           ///< share of the duration

  std::vector<Level> levels() const {
    if (limits_.effort == TubeEffort::thorough) return {std::begin(kLevels), std::end(kLevels)};
    std::vector<Level> levels = {{kLevels[0].weight, limits_.quick_rounds, kQuickLongest}};
    levels.insert(levels.end(), std::begin(kQuickLevels), std::end(kQuickLevels));
    return levels;
  }

  const StepLimits& limits(const MotionWindow<D>& m) const { return m.stride == 1 ? limits_ : longer_[m.stride / 4]; }

  /// Rounds of bending and retiming.
  bool hurry(MotionWindow<D>& m, const Level& level, const Monitor& monitor) {
    for (int i = 0; i < level.rounds; ++i) {
      if (monitor.is_cancelled()) return false;
      const auto before = static_cast<double>(m.size());
      if (!round_.solve(m, {level.weight, true, {0.9999, 0.9995, 0.998, 0.998}})) return false;
      warp_.apply(m, round_.bend, round_.pace);
      if (!warp_.was().empty()) round_.multipliers.move(warp_.was());
      passes_.apply(path_, m);
      if (i > 0 && before - static_cast<double>(m.size()) < kGain * before) break;
    }
    return true;
  }

  const TubePath& path_;
  const StepLimits& limits_;
  StepLimits longer_[2];  ///< of steps twice and four times as long
  NewtonRound<D> round_;
  Warp<D> warp_;
  PassRefiner<D> passes_;
  WindowSettler<D> settler_;
};

}  // namespace toolpace::detail::tube
