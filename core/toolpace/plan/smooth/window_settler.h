#pragma once
/// From a motion that nearly keeps its limits to one that does.

#include "toolpace/base/monitor.h"
#include "toolpace/plan/smooth/motion_parts.h"
#include "toolpace/plan/smooth/newton_round.h"
#include "toolpace/plan/smooth/refine_passes.h"
#include "toolpace/plan/smooth/tube_check.h"
#include "toolpace/plan/smooth/warp.h"

namespace toolpace::detail::tube {

/// Works where something is broken, and leaves the rest of the motion as it is.
template <int D>
class WindowSettler {
 public:
  using Vec = Eigen::Matrix<double, D, 1>;
  WindowSettler(const TubePath& path, const StepLimits& limits)
      : path_(path), limits_(limits), round_(path), check_(path, limits) {}

  /// @param multipliers  of the rounds that came to this motion
  /// @return true if the motion keeps every limit now; otherwise it is of no use
  bool apply(MotionWindow<D>& m, Multipliers<D>& multipliers, const Monitor& monitor) {
    has_slowed_ = false;
    for (int i = 0; i < kMostRounds; i += kAtOnce) {
      const Use use = check_.measure(m);
      if (use.is_good()) return true;
      if (!bend_spots(m, use, multipliers, monitor)) break;
    }
    has_slowed_ = true;
    std::size_t reach = 2 * kReach;
    for (int pass = 0; pass < kPasses && !monitor.is_cancelled(); ++pass, reach *= 2) {
      const Use use = check_.measure(m);
      if (use.is_good()) return true;
      if (!slow_down_spots(m, use, reach, monitor)) return false;
    }
    return check_.measure(m).is_good();
  }

  /// Whether the last motion had to become slower somewhere.
  bool has_slowed() const { return has_slowed_; }

  const TubeCheck<D>& check() const { return check_; }

 private:
  static constexpr std::size_t kReach = 24;  // control points to either side of what is broken that may move
  static constexpr int kPasses = 4;          // of slowing down; the reach is doubled after each
  static constexpr double kWeight = 0.0005;
  static constexpr int kMostRounds = 24;              // where nothing is slowed down
  static constexpr int kAtOnce = 2;                   // steps before what is broken is looked at again
  static constexpr int kAttempts = 10, kRounds = 14;  // a little slower each time; of steps in each
  static constexpr int kPatience = 4;                 // steps within which the worst must become better
  static constexpr double kSlower = 0.0025;           // first share of slowing down, doubled each time

  /// Control points that begin … end − 1 belong together.
  struct Spot {
    std::size_t begin, end;
  };

  static std::vector<Spot> spots(const std::vector<std::size_t>& over, std::size_t size, std::size_t reach) {
    std::vector<Spot> all;
    for (const std::size_t k : over) {
      // Where less than that is left up to an end, the part begins there.
      const std::size_t begin = k > reach + kReach ? k - reach : 1;
      const std::size_t end = k + reach + kReach < size - 2 ? k + reach : size - 2;
      if (all.empty() || begin > all.back().end) {
        all.push_back({begin, end});
      } else {
        all.back().end = std::max(all.back().end, end);
      }
    }
    return all;
  }

  /// A few steps at fixed duration around what is broken.
  bool bend_spots(MotionWindow<D>& m, const Use& use, Multipliers<D>& multipliers, const Monitor& monitor) {
    for (const Spot& spot : spots(use.over, m.size(), kReach)) {
      MotionWindow<D> piece = part(m, spot.begin, spot.end);
      const std::size_t from = spot.begin - 1, vertex = piece.first - m.first;
      round_.begin(piece, limits_);
      round_.multipliers.take(multipliers, from, vertex);
      for (int i = 0; i < kAtOnce; ++i) {
        if (monitor.is_cancelled() || !bend(piece)) return false;
      }
      multipliers.put(round_.multipliers, from, vertex);
      put(m, piece, from, vertex);
    }
    return true;
  }

  bool slow_down_spots(MotionWindow<D>& m, const Use& use, std::size_t reach, const Monitor& monitor) {
    MotionWindow<D> out;
    std::size_t done = 1;
    const auto add = [&](std::size_t end) {
      if (end > done) append(out, part(m, done, end));
      done = end;
    };
    for (const Spot& spot : spots(use.over, m.size(), reach)) {
      add(spot.begin);
      MotionWindow<D> piece = part(m, spot.begin, spot.end);
      if (!settle_slower(piece, monitor)) return false;
      append(out, piece);
      done = spot.end;
    }
    add(m.size() - 2);
    m = std::move(out);
    return true;
  }

  /// A little slower around what is broken, and again, until it can be settled.
  bool settle_slower(MotionWindow<D>& m, const Monitor& monitor) {
    round_.begin(m, limits_);
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      slow_down(m, check_.measure(m), kSlower * (1 << attempt));
      if (settle(m, monitor)) return true;
      if (monitor.is_cancelled()) return false;
    }
    return false;
  }

  /// At fixed duration, as long as that makes it better.
  bool settle(MotionWindow<D>& m, const Monitor& monitor) {
    double worst[kRounds + 1];
    for (int i = 0; i <= kRounds; ++i) {
      const Use use = check_.measure(m);
      if (use.is_good()) return true;
      worst[i] = std::max(use.limits, use.tube);
      if (i >= kPatience && worst[i] > worst[i - kPatience]) return false;
      if (monitor.is_cancelled() || !bend(m)) return false;
    }
    return false;
  }

  bool bend(MotionWindow<D>& m) {
    if (!round_.solve(m, {kWeight, false, {0.9999, 0.9995, 0.999, 0.999}})) return false;
    apply_step(m, round_.bend, round_.pace);
    return true;
  }

  void apply_step(MotionWindow<D>& m, const std::vector<Vec>& bend, const std::vector<double>& pace) {
    warp_.apply(m, bend, pace);
    if (!warp_.was().empty()) round_.multipliers.move(warp_.was());
    passes_.apply(path_, m);
  }

  /// Slows down by the share `by` around what is over, fading out smoothly.
  void slow_down(MotionWindow<D>& m, const Use& use, double by) {
    const std::size_t n = m.size();
    constexpr std::size_t kAround = 60;
    std::vector<double> free(n, 1.0), low;
    for (const std::size_t at : use.over) free[std::min(at + 1, n - 1)] = 0;
    smooth_minimum(free, kAround, low);
    std::vector<double> pace(n);
    for (std::size_t k = 0; k < n; ++k) pace[k] = k < 3 || k + 3 >= n ? 0 : -by * (1 - free[k]) * ease(m, k);
    apply_step(m, std::vector<Vec>(n, Vec::Zero()), pace);
  }

  const TubePath& path_;
  const StepLimits& limits_;
  NewtonRound<D> round_;
  TubeCheck<D> check_;
  Warp<D> warp_;
  PassRefiner<D> passes_;
  bool has_slowed_ = false;
};

}  // namespace toolpace::detail::tube
