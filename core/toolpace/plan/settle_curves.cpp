#include "toolpace/plan/settle_curves.h"

#include <algorithm>
#include <cmath>

#include "toolpace/limits/dynamics_table.h"
#include "toolpace/plan/block/block_plan.h"

namespace toolpace {
namespace {

/// Shares of the top speed that are tried first, and how narrow the search between them becomes.
constexpr double kShares[] = {1.0, 0.97, 0.93, 0.88, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3};
constexpr std::size_t kInVain = 3;  // shares in a row
constexpr double kNarrow = 0.004;
constexpr double kGolden = 0.6180339887498949;
/// Curves whose caps are no more than this share of their top speeds leave nearly all of their limits: no search.
constexpr double kGentle = 0.5;
/// Rounds of lowering caps to the speeds that are reached, as long as a cap falls and the time does by such shares.
constexpr int kMostLowerings = 3;
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
    if (is_gentle()) {
      least_ = time_of(1.0);
    } else {
      search();
      raise();
    }
    lower();
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

  void search() {
    double best = kShares[0], least = time_of(best);
    std::size_t at = 0;
    for (std::size_t k = 1; k < std::size(kShares); ++k) {
      const double time = time_of(kShares[k]);
      if (time < least) {
        least = time;
        best = kShares[k];
        at = k;
      }
      if (k >= at + kInVain) break;
    }
    double low = kShares[std::min(at + 1, std::size(kShares) - 1)], high = kShares[at > 0 ? at - 1 : 0];
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
    set(best);
    least_ = least;
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
