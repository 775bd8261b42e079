#include "toolpace/plan/settle_curves.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "toolpace/limits/dynamics_table.h"
#include "toolpace/plan/block/block_plan.h"
#include "toolpace/plan/choice_search.h"
#include "toolpace/plan/curve_run.h"

namespace toolpace {
namespace {

using detail::CurveRun;
using Choice = detail::CurveChoice;

/// The time of a run may have several valleys: each is looked into where that costs little, in chains of no more curves, else the
/// nearest.
constexpr std::size_t kFewCurves = 3000;
constexpr std::size_t kSharesKept = 20;  // of each curve of few
/// In runs of many curves, of which all are tried together, samples of so many blocks tell what suits them.
constexpr std::size_t kSampledBlocks = 1024, kSamples = 8;
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

/// Stretches of a long run, evenly spread, that stand for all of it.
class Sample {
 public:
  Sample(const SpeedLimits& all, std::size_t begin, std::size_t end, const CurveUse& use) : use_(use) {
    const std::size_t blocks = end - begin;
    const std::size_t step = blocks / kSamples, rest = step - kSampledBlocks;
    for (std::size_t k = 0; k < kSamples; ++k) {
      const std::size_t first = begin + k * step + rest / 2;
      runs_.emplace_back(all, first, first + kSampledBlocks, use, kRemembered);
    }
  }

  double time_of(const Choice& choice) {
    double sum = 0;
    for (CurveRun& run : runs_) {
      run.apply(std::vector<Choice>(run.curves(), choice));
      sum += detail::time_block_ramps(run.limits(), use_.law, use_.blocks, kMargin);
    }
    return sum;
  }

 private:
  static constexpr std::size_t kRemembered = 4;
  static constexpr std::size_t kMargin = 128;  // blocks, in which it comes from rest and goes back to it
  CurveUse use_;
  std::vector<CurveRun> runs_;
};

/// One run of blocks, its curves at changing caps.
class RunSettler {
 public:
  /// @param share  of ChoiceSearch::nearest_valley()
  RunSettler(const SpeedLimits& all, std::size_t begin, std::size_t end, const CurveUse& use, std::size_t& share)
      : nearest_(share),
        use_(use),
        usual_{1.0, usual_split(use.at_cap)},
        is_thorough_(all.curved.size() <= kFewCurves),
        run_(all, begin, end, use, is_thorough_ ? kSharesKept : 1),
        choice_(run_.curves(), usual_) {
    if (use.samples && end - begin > kSamples * kSampledBlocks) sample_.emplace(all, begin, end, use);
  }

  /// The run with its curves' caps chosen.
  const CurveRun& run() {
    if (choice_.empty()) return run_;
    std::vector<Choice> fastest;
    double least = kUnlimited;
    for (const Choice& start : starts()) {
      std::fill(choice_.begin(), choice_.end(), start);
      measure();
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
  double time() const { return detail::time_block_ramps(run_.limits(), use_.law, use_.blocks); }
  void apply() { run_.apply(choice_); }

  std::vector<Choice> starts() {
    if (is_gentle()) return {usual_};
    const detail::ChoiceRules rules{use_.at_cap, run_.has_jerk()};
    if (sample_)
      return {
          detail::ChoiceSearch(rules, [&](const Choice& c) { return sample_->time_of(c); }).nearest_valley(nearest_)};
    detail::ChoiceSearch search(rules, [&](const Choice& c) { return time_of(c); });
    return is_thorough_ ? search.valleys() : std::vector<Choice>{search.nearest_valley(nearest_)};
  }

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

  void measure() {
    apply();
    speeds_ = detail::block_ramp_speeds(run_.limits(), use_.law, use_.blocks);
    least_ = speeds_.time;
  }

  /// Curves that are run through at their cap need not change speed: they may have their top speed, if the plan as a whole
  /// gains by it.
  void raise() {
    const std::vector<Choice> before = choice_;
    bool raised = false;
    for (std::size_t c = 0; c < run_.curves(); ++c) {
      const std::size_t i = run_.block(c);
      const double cap = run_.limits().block_cap[i] * kAtCap;
      if (speeds_.node[i] < cap || speeds_.node[i + 1] < cap || choice_[c].share == 1.0) continue;
      choice_[c].share = 1.0;
      raised = true;
    }
    if (raised) measure_if_faster(before);
  }

  /// Where the speed does not come up to a curve's cap, the cap leaves less than it could.
  void lower() {
    for (int round = 0; round < kMostLowerings; ++round) {
      const std::vector<Choice> last = choice_;
      bool lowered = false;
      for (std::size_t c = 0; c < run_.curves(); ++c) {
        const std::size_t i = run_.block(c);
        const double peak = speeds_.peak[i];
        if (!(peak < kLowered * run_.limits().block_cap[i]) || !(peak > 0)) continue;
        choice_[c].share = peak / run_.top(c);
        lowered = true;
      }
      const double before = least_;
      if (!lowered || !measure_if_faster(last) || least_ > before * (1 - kGain)) return;
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

  /// The same, and the speeds of what is taken.
  bool measure_if_faster(const std::vector<Choice>& before) {
    const double least = least_;
    detail::BlockSpeeds last = std::move(speeds_);
    measure();
    if (least_ < least) return true;
    least_ = least;
    speeds_ = std::move(last);
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
  std::optional<Sample> sample_;
  detail::BlockSpeeds speeds_;  // of the fastest choices until now, as raise() and lower() ask for them
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
  std::size_t share = detail::kUsualShare;
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
