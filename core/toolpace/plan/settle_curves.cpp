#include "toolpace/plan/settle_curves.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "toolpace/limits/dynamics_table.h"
#include "toolpace/plan/block/block_plan.h"
#include "toolpace/plan/curve_run.h"

namespace toolpace {
namespace {

using detail::CurveRun;
using Choice = detail::CurveChoice;

/// Shares of the top speed, and splits of the jerk that they leave, that are tried first, and how narrow the search between them
/// becomes.
constexpr double kShares[] = {1.0,  0.97, 0.95, 0.93, 0.905, 0.88, 0.84, 0.8, 0.75, 0.7,
                              0.65, 0.6,  0.55, 0.5,  0.45,  0.4,  0.35, 0.3, 0.2,  0.1};
constexpr std::size_t kUsualShare = 6;  // of these
constexpr double kSplits[] = {0.95, 0.85, 0.71, 0.5, 0.25, 0.1, 0.0, -0.12, -0.3};
constexpr double kNarrow = 0.002;
constexpr double kGolden = 0.6180339887498949;
/// The time of a run may have several valleys: each is looked into where that costs little, in chains of no more curves, else the
/// first that is found.
constexpr std::size_t kFewCurves = 3000;
constexpr std::size_t kMostValleys = 3;
constexpr std::size_t kInVain = 2;  // shares in a row on either side, where there are many curves
constexpr int kParabolas = 2;       // by which the lowest place is then sought
/// Where it costs little each curve's share and part is turned by itself, by such steps.
constexpr std::size_t kSmallRun = 400;  // blocks times curves
constexpr double kFirstTurn = 0.1, kLeastTurn = 0.002;
constexpr double kMostSplit = 0.995, kLeastSplit = -0.9;
/// Curves whose caps are no more than this share of their top speeds leave nearly all of their limits: no search.
constexpr double kGentle = 0.5;
/// Rounds of lowering caps to the speeds that are reached, as long as a cap falls and the time does by such shares.
constexpr int kMostLowerings = 3, kMostRounds = 4;
constexpr double kLowered = 0.98, kGain = 1e-4;
/// Nodes that are crossed no faster than this share of both neighbours' caps part runs like rests.
constexpr double kNearRest = 0.3;
constexpr double kAtCap = 1 - 1e-9;

/// A place that one of a row of values is, between its neighbours.
template <std::size_t count>
std::pair<double, double> beside(const double (&values)[count], double value) {
  const auto* const at = std::find(std::begin(values), std::end(values), value);
  return {at + 1 == std::end(values) ? *at : at[1], at == std::begin(values) ? *at : at[-1]};
}

/// One run of blocks, its curves at changing caps.
class RunSettler {
 public:
  /// @param share  which of kShares suited the run before; which suits this one is left there
  RunSettler(const SpeedLimits& all, std::size_t begin, std::size_t end, const CurveUse& use, std::size_t& share)
      : nearest_(share),
        use_(use),
        usual_{1.0, usual_split(use.at_cap)},
        is_thorough_(all.curved.size() <= kFewCurves),
        run_(all, begin, end, use, is_thorough_ ? std::size(kShares) : 1),
        choice_(run_.curves(), usual_) {}

  /// The run with its curves' caps chosen.
  const CurveRun& run() {
    if (choice_.empty()) return run_;
    std::vector<Choice> fastest;
    double least = kUnlimited;
    for (const Choice& start : starts()) {
      least_ = time_of(start);
      raise();
      lower();
      if (is_small()) polish();
      if (!(least_ < least)) continue;
      least = least_;
      fastest = choice_;
    }
    if (fastest.empty()) fastest.assign(run_.curves(), usual_);
    if (choice_ != fastest) {
      choice_ = fastest;
      apply();
    }
    return run_;
  }

 private:
  struct Timed {
    Choice choice;
    double time;
  };

  double time() const { return detail::time_block_ramps(run_.limits(), use_.law, use_.blocks); }
  detail::BlockSpeeds speeds() const { return detail::block_ramp_speeds(run_.limits(), use_.law, use_.blocks); }
  void apply() { run_.apply(choice_); }

  bool is_gentle() const {
    for (std::size_t c = 0; c < run_.curves(); ++c) {
      if (run_.widest_cap(c) > kGentle * run_.top(c)) return false;
    }
    return true;
  }

  double time_of(const Choice& choice) {
    std::fill(choice_.begin(), choice_.end(), choice);
    apply();
    return time();
  }

  std::vector<Choice> starts() {
    if (is_gentle()) return {usual_};
    return is_thorough_ ? valleys() : std::vector<Choice>{nearest_valley()};
  }

  /// The lowest share with the usual split, downhill from where that of the last run was: runs of a part are like each other.
  Choice nearest_valley() {
    std::array<double, std::size(kShares)> times;
    times.fill(kUnlimited);
    const auto try_at = [&](std::size_t k) {
      times[k] = time_of({kShares[k], usual_.split});
      if (times[k] < times[nearest_]) nearest_ = k;
    };
    const std::size_t first = nearest_;
    try_at(first);
    for (std::size_t k = first; k-- > 0 && k + kInVain >= nearest_;) try_at(k);
    for (std::size_t k = first + 1; k < times.size() && k <= nearest_ + kInVain; ++k) try_at(k);
    if (nearest_ == 0 || nearest_ + 1 == times.size()) return {kShares[nearest_], usual_.split};
    std::array<double, 3> share{kShares[nearest_ + 1], kShares[nearest_], kShares[nearest_ - 1]};
    std::array<double, 3> time{times[nearest_ + 1], times[nearest_], times[nearest_ - 1]};
    for (int i = 0; i < kParabolas; ++i) {
      const double low = share[1] - share[0], high = share[2] - share[1];
      const double falls = (time[0] - time[1]) / low, rises = (time[2] - time[1]) / high;
      const double x = share[1] + (falls * high - rises * low) / (2 * (falls + rises));
      if (!(x > share[0] && x < share[2]) || x == share[1]) break;
      const double t = time_of({x, usual_.split});
      const std::size_t side = x < share[1] ? 0 : 2;
      if (t < time[1]) {
        share[2 - side] = share[1], time[2 - side] = time[1];
        share[1] = x, time[1] = t;
      } else {
        share[side] = x, time[side] = t;
      }
    }
    return {share[1], usual_.split};
  }

  /// Choices, the same for all curves, from which no other one near by is faster; the fastest first.
  std::vector<Choice> valleys() {
    std::array<std::vector<Timed>, std::size(kSplits)> rows;
    for (std::size_t p = 0; p < std::size(kSplits); ++p) {
      const bool may_help = use_.at_cap == AtCap::rests ? kSplits[p] <= 0.5 : kSplits[p] >= 0;
      if (kSplits[p] == usual_.split || (run_.has_jerk() && may_help)) rows[p] = timed_shares(kSplits[p]);
    }
    std::vector<Timed> bottoms;
    for (std::size_t p = 0; p < std::size(kSplits); ++p) {
      for (std::size_t k = 0; k < rows[p].size(); ++k) {
        const auto is_passed_by = [&](const std::vector<Timed>& row) {
          return std::any_of(row.begin() + static_cast<std::ptrdiff_t>(k > 0 ? k - 1 : 0),
                             row.begin() + static_cast<std::ptrdiff_t>(std::min(row.size(), k + 2)),
                             [&](const Timed& other) { return other.time < rows[p][k].time; });
        };
        const auto first = rows.begin() + static_cast<std::ptrdiff_t>(p > 0 ? p - 1 : 0);
        const auto last = rows.begin() + static_cast<std::ptrdiff_t>(std::min(p + 2, rows.size()));
        if (std::none_of(first, last, is_passed_by)) bottoms.push_back(rows[p][k]);
      }
    }
    std::stable_sort(bottoms.begin(), bottoms.end(), [](const Timed& a, const Timed& b) { return a.time < b.time; });
    bottoms.resize(std::min(bottoms.size(), kMostValleys));
    std::vector<Choice> choices;
    for (const Timed& bottom : bottoms) choices.push_back(bottom_near(bottom));
    return choices;
  }

  /// All shares with one split of the jerk.
  std::vector<Timed> timed_shares(double split) {
    std::vector<Timed> row;
    for (const double share : kShares) row.push_back({{share, split}, time_of({share, split})});
    return row;
  }

  /// The fastest choice between the neighbours of one that is tried first: by one of the two, and then by the other.
  Choice bottom_near(Timed start) {
    Timed best = narrowed(start, &Choice::share, beside(kShares, start.choice.share));
    return run_.has_jerk() ? narrowed(best, &Choice::split, beside(kSplits, start.choice.split)).choice : best.choice;
  }

  Timed narrowed(Timed best, double Choice::*what, std::pair<double, double> between) {
    auto [low, high] = between;
    const auto at = [&](double x) {
      Timed other = best;
      other.choice.*what = x;
      other.time = time_of(other.choice);
      return other;
    };
    Timed x = at(high - kGolden * (high - low)), y = at(low + kGolden * (high - low));
    for (;;) {
      const Timed& faster = x.time < y.time ? x : y;
      if (faster.time < best.time) best = faster;
      if (!(high - low > kNarrow)) return best;
      if (x.time < y.time) {
        high = y.choice.*what;
        y = x;
        x = at(high - kGolden * (high - low));
      } else {
        low = x.choice.*what;
        x = y;
        y = at(low + kGolden * (high - low));
      }
    }
  }

  /// Curves that are run through at their cap need not change speed: they may have their top speed, if the plan as a whole
  /// gains by it.
  void raise() {
    const std::vector<Choice> before = choice_;
    const std::vector<double> v = speeds().node;
    bool raised = false;
    for (std::size_t c = 0; c < run_.curves(); ++c) {
      const std::size_t i = run_.block(c);
      const double cap = run_.limits().block_cap[i] * kAtCap;
      if (v[i] < cap || v[i + 1] < cap || choice_[c].share == 1.0) continue;
      choice_[c].share = 1.0;
      raised = true;
    }
    if (raised) keep_if_faster(before);
  }

  /// Where the speed does not come up to a curve's cap, the cap leaves less than it could.
  void lower() {
    for (int round = 0; round < kMostLowerings; ++round) {
      const std::vector<Choice> last = choice_;
      const std::vector<double> peak = speeds().peak;
      bool lowered = false;
      for (std::size_t c = 0; c < run_.curves(); ++c) {
        const std::size_t i = run_.block(c);
        if (!(peak[i] < kLowered * run_.limits().block_cap[i]) || !(peak[i] > 0)) continue;
        choice_[c].share = peak[i] / run_.top(c);
        lowered = true;
      }
      const double before = least_;
      if (!lowered || !keep_if_faster(last) || least_ > before * (1 - kGain)) return;
    }
  }

  bool is_small() const { return is_thorough_ && run_.blocks() * run_.curves() <= kSmallRun; }

  /// Turns each curve's choice by itself, as long as that saves time.
  void polish() {
    for (double turn = kFirstTurn; turn > kLeastTurn; turn /= 2) {
      bool gains = true;
      for (int round = 0; round < kMostRounds && gains; ++round) {
        gains = false;
        for (std::size_t c = 0; c < run_.curves(); ++c) {
          gains |= turn_share(c, 1 / (1 + turn)) || turn_share(c, 1 + turn);
          if (run_.has_jerk()) gains |= turn_split(c, -turn) || turn_split(c, turn);
        }
      }
    }
  }

  bool turn_share(std::size_t c, double factor) {
    const std::vector<Choice> before = choice_;
    choice_[c].share = std::min(1.0, choice_[c].share * factor);
    return choice_[c] != before[c] && keep_if_faster(before);
  }

  bool turn_split(std::size_t c, double by) {
    const std::vector<Choice> before = choice_;
    choice_[c].split = std::clamp(choice_[c].split + by, kLeastSplit, kMostSplit);
    return choice_[c] != before[c] && keep_if_faster(before);
  }

  /// Takes the new choices, or goes back to these.
  bool keep_if_faster(const std::vector<Choice>& before) {
    apply();
    const double now = time();
    if (now < least_) {
      least_ = now;
      return true;
    }
    choice_ = before;
    apply();
    return false;
  }

  std::size_t& nearest_;
  CurveUse use_;
  Choice usual_;
  bool is_thorough_;
  CurveRun run_;
  std::vector<Choice> choice_;  // one entry a curve
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
  std::size_t share = kUsualShare;
  for (std::size_t begin = 0, end = 0; begin < n && !monitor.is_cancelled(); begin = end) {
    for (end = begin + 1; end < n && use.blocks > 1 && !is_near_rest(widest, end);) ++end;
    RunSettler settler(widest, begin, end, use, share);
    const CurveRun& run = settler.run();
    for (std::size_t i = begin; i < end; ++i) {
      cap[i] = run.limits().block_cap[i - begin];
      ramp[i] = chosen.add(run.limits().dynamics_of(i - begin), run.cause(i - begin));
    }
  }
  for (const std::uint32_t i : widest.curved) {
    // Near a pole it is not the curve that is to blame.
    const bool is_near_pole = widest.block_cause[i] == Cause::singularity;
    if (cap[i] < widest.block_cap[i] && !is_near_pole) widest.block_cause[i] = Cause::curvature;
  }
  widest.block_cap = std::move(cap);
  widest.ramp = std::move(ramp);
  std::move(chosen).give_to(widest);
  lower_nodes(widest);
  return widest;
}

}  // namespace toolpace
