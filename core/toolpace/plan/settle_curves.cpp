#include "toolpace/plan/settle_curves.h"

#include <algorithm>
#include <cmath>

#include "toolpace/limits/dynamics_table.h"
#include "toolpace/plan/block/block_plan.h"

namespace toolpace {
namespace {

/// Shares of the top speed that are tried first, and how narrow the search between them becomes.
constexpr double kShares[] = {1.0,  0.97, 0.95, 0.93, 0.905, 0.88, 0.84, 0.8, 0.75, 0.7,
                              0.65, 0.6,  0.55, 0.5,  0.45,  0.4,  0.35, 0.3, 0.2,  0.1};
constexpr std::size_t kLast = std::size(kShares) - 1;
constexpr double kNarrow = 0.002;
constexpr double kGolden = 0.6180339887498949;
/// The time of a run may have several valleys by the share: each is looked into where that costs little, in chains of no more
/// curves, else the first that is found.
constexpr std::size_t kFewCurves = 3000;
constexpr std::size_t kMostValleys = 3;
constexpr std::size_t kInVain = 5;  // shares in a row, where there are many curves
/// Where it costs little each curve's share is turned by itself, by such parts.
constexpr std::size_t kSmallRun = 400;  // blocks times curves
constexpr double kFirstTurn = 0.1, kLeastTurn = 0.002;
/// Curves whose caps are no more than this share of their top speeds leave nearly all of their limits: no search.
constexpr double kGentle = 0.5;
/// Rounds of lowering caps to the speeds that are reached, as long as a cap falls and the time does by such shares.
constexpr int kMostLowerings = 3, kMostRounds = 4;
constexpr double kLowered = 0.98, kGain = 1e-4;
/// Nodes that are crossed no faster than this share of both neighbours' caps part runs like rests.
constexpr double kNearRest = 0.3;
constexpr double kAtCap = 1 - 1e-9;

/// One run of blocks, its curves at changing caps.
class RunSettler {
 public:
  RunSettler(const SpeedLimits& all, std::size_t begin, std::size_t end, const CurveUse& use)
      : all_(all), begin_(begin), end_(end), use_(use), run_(slice(all, begin, end)) {
    const auto first = std::lower_bound(all.curved.begin(), all.curved.end(), begin);
    const auto last = std::lower_bound(first, all.curved.end(), end);
    first_ = static_cast<std::size_t>(first - all.curved.begin());
    count_ = static_cast<std::size_t>(last - first);
    share_.assign(count_, 1.0);
  }

  /// The run with its curves' caps chosen.
  const SpeedLimits& run() {
    if (count_ == 0) return run_;
    std::vector<double> fastest;
    double least = kUnlimited;
    for (const double share : is_gentle() ? std::vector<double>{1.0} : valleys()) {
      least_ = time_of(share);
      raise();
      lower();
      if (is_small()) polish();
      if (!(least_ < least)) continue;
      least = least_;
      fastest = share_;
    }
    if (fastest.empty()) fastest.assign(count_, 1.0);
    if (share_ != fastest) {
      share_ = fastest;
      apply();
    }
    return run_;
  }

 private:
  const CurveBudget& budget(std::size_t c) const { return all_.budget[first_ + c]; }
  std::size_t block(std::size_t c) const { return all_.curved[first_ + c] - begin_; }
  double widest_cap(std::size_t c) const { return all_.block_cap[begin_ + block(c)]; }

  bool is_gentle() const {
    for (std::size_t c = 0; c < count_; ++c) {
      if (widest_cap(c) > kGentle * budget(c).top_speed()) return false;
    }
    return true;
  }

  void set(double share) {
    std::fill(share_.begin(), share_.end(), share);
    apply();
  }

  /// Caps and ramp limits by the shares. Nodes keep their own caps: plans see the lower of these and their neighbours'.
  void apply() {
    DynamicsTable different;
    std::size_t c = 0;
    for (std::size_t i = 0; i < run_.size(); ++i) {
      Dynamics dynamics = all_.dynamics_of(begin_ + i);
      Cause cause = all_.dynamics_cause[all_.ramp[begin_ + i]];
      if (c < count_ && block(c) == i) {
        const CurveBudget& b = budget(c);
        const AlongPath& along = all_.along[all_.ceiling[first_ + c]];
        run_.block_cap[i] = std::min(widest_cap(c), share_[c] * b.top_speed());
        dynamics = within(along.dynamics, b.at(run_.block_cap[i], use_.at_cap));
        cause = cause_of(dynamics, along);
        ++c;
      }
      run_.ramp[i] = different.add(dynamics, cause);
    }
    std::move(different).give_to(run_);
  }

  double time_of(double share) {
    set(share);
    return detail::time_block_ramps(run_, use_.law);
  }

  /// Shares, the same for all curves, from which no other one near by is faster; the fastest first.
  std::vector<double> valleys() {
    std::vector<double> time;
    std::size_t least = 0;
    const bool is_thorough = all_.curved.size() <= kFewCurves;
    while (time.size() < std::size(kShares) && (is_thorough || time.size() <= least + kInVain)) {
      time.push_back(time_of(kShares[time.size()]));
      if (time.back() < time[least]) least = time.size() - 1;
    }
    std::vector<std::size_t> bottoms;
    for (std::size_t k = 0; k < time.size(); ++k) {
      const bool falls = k == 0 || time[k] < time[k - 1], rises = k + 1 == time.size() || time[k] <= time[k + 1];
      if (falls && rises) bottoms.push_back(k);
    }
    std::stable_sort(bottoms.begin(), bottoms.end(), [&](std::size_t a, std::size_t b) { return time[a] < time[b]; });
    bottoms.resize(std::min(bottoms.size(), is_thorough ? kMostValleys : 1));
    std::vector<double> shares;
    for (const std::size_t k : bottoms) shares.push_back(bottom_near(k, time[k]));
    return shares;
  }

  /// The fastest share between both neighbours of one that is tried first, of which the time is known.
  double bottom_near(std::size_t at, double least) {
    double best = kShares[at], low = kShares[std::min(at + 1, kLast)], high = kShares[at > 0 ? at - 1 : 0];
    double x = high - kGolden * (high - low), y = low + kGolden * (high - low);
    double fx = time_of(x), fy = time_of(y);
    while (high - low > kNarrow) {
      if (fx < fy) {
        high = y;
        y = x;
        fy = fx;
        x = high - kGolden * (high - low);
        fx = time_of(x);
      } else {
        low = x;
        x = y;
        fx = fy;
        y = low + kGolden * (high - low);
        fy = time_of(y);
      }
      if (std::min(fx, fy) < least) {
        least = std::min(fx, fy);
        best = fx < fy ? x : y;
      }
    }
    return best;
  }

  /// Curves that are run through at their cap need not change speed: they may have their top speed, if the plan as a whole
  /// gains by it.
  void raise() {
    const std::vector<double> shares = share_;
    const std::vector<double> v = detail::block_ramp_speeds(run_, use_.law).node;
    bool raised = false;
    for (std::size_t c = 0; c < count_; ++c) {
      const std::size_t i = block(c);
      const double cap = run_.block_cap[i] * kAtCap;
      if (v[i] < cap || v[i + 1] < cap || share_[c] == 1.0) continue;
      share_[c] = 1.0;
      raised = true;
    }
    if (!raised) return;
    keep_if_faster(shares);
  }

  /// Where the speed does not come up to a curve's cap, the cap leaves less than it could.
  void lower() {
    for (int round = 0; round < kMostLowerings; ++round) {
      const std::vector<double> shares = share_;
      const std::vector<double> peak = detail::block_ramp_speeds(run_, use_.law).peak;
      bool lowered = false;
      for (std::size_t c = 0; c < count_; ++c) {
        const std::size_t i = block(c);
        if (!(peak[i] < kLowered * run_.block_cap[i]) || !(peak[i] > 0)) continue;
        share_[c] = peak[i] / budget(c).top_speed();
        lowered = true;
      }
      const double before = least_;
      if (!lowered || !keep_if_faster(shares) || least_ > before * (1 - kGain)) return;
    }
  }

  bool is_small() const { return all_.curved.size() <= kFewCurves && run_.size() * count_ <= kSmallRun; }

  /// Turns each curve's share by itself, as long as that saves time.
  void polish() {
    for (double turn = kFirstTurn; turn > kLeastTurn; turn /= 2) {
      bool gains = true;
      for (int round = 0; round < kMostRounds && gains; ++round) {
        gains = false;
        for (std::size_t c = 0; c < count_; ++c) gains |= turn_share(c, 1 / (1 + turn)) || turn_share(c, 1 + turn);
      }
    }
  }

  bool turn_share(std::size_t c, double factor) {
    const std::vector<double> shares = share_;
    share_[c] = std::min(1.0, share_[c] * factor);
    return share_[c] != shares[c] && keep_if_faster(shares);
  }

  /// Takes the new shares, or goes back to these.
  bool keep_if_faster(const std::vector<double>& shares) {
    apply();
    const double time = detail::time_block_ramps(run_, use_.law);
    if (time < least_) {
      least_ = time;
      return true;
    }
    share_ = shares;
    apply();
    return false;
  }

  const SpeedLimits& all_;
  std::size_t begin_, end_;
  CurveUse use_;
  SpeedLimits run_;
  std::size_t first_, count_;  // of the run's curves
  std::vector<double> share_;  // of each curve's top speed
  double least_ = 0;
};

bool is_near_rest(const SpeedLimits& limits, std::size_t node) {
  return limits.node_cap[node] <= kNearRest * std::min(limits.block_cap[node - 1], limits.block_cap[node]);
}

/// Caps of curves that have become lower are those of their nodes, too.
void lower_nodes(SpeedLimits& limits) {
  for (const std::uint32_t i : limits.curved) {
    for (const std::size_t node : {std::size_t{i}, std::size_t{i} + 1}) {
      if (limits.node_cap[node] <= limits.block_cap[i]) continue;
      limits.node_cap[node] = limits.block_cap[i];
      limits.node_cause[node] = limits.block_cause[i];
    }
  }
}

}  // namespace

SpeedLimits settle_curves(SpeedLimits widest, const CurveUse& use, const Monitor& monitor) {
  const std::size_t n = widest.size();
  if (widest.curved.empty()) return widest;
  DynamicsTable chosen;
  std::vector<std::uint32_t> ramp(n);
  std::vector<double> cap = widest.block_cap;
  for (std::size_t begin = 0, end = 0; begin < n && !monitor.is_cancelled(); begin = end) {
    for (end = begin + 1; end < n && !use.stops_everywhere && !is_near_rest(widest, end);) ++end;
    RunSettler settler(widest, begin, end, use);
    const SpeedLimits& run = settler.run();
    for (std::size_t i = begin; i < end; ++i) {
      cap[i] = run.block_cap[i - begin];
      ramp[i] = chosen.add(run.dynamics_of(i - begin), run.dynamics_cause[run.ramp[i - begin]]);
    }
  }
  for (const std::uint32_t i : widest.curved) {
    if (cap[i] < widest.block_cap[i]) widest.block_cause[i] = Cause::curvature;
  }
  widest.block_cap = std::move(cap);
  widest.ramp = std::move(ramp);
  std::move(chosen).give_to(widest);
  lower_nodes(widest);
  return widest;
}

}  // namespace toolpace
