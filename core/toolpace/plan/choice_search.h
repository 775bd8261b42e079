#pragma once
/// The share of their top speeds, and the split of the jerk, that suit the curves of a run best, the same for all.

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "toolpace/plan/curve_run.h"

namespace toolpace::detail {

/// What is looked into.
struct ChoiceRules {
  AtCap at_cap;
  bool has_jerk;  ///< without there is no split to choose
};

/// Number of the share that a search of the nearest valley begins with.
inline constexpr std::size_t kUsualShare = 6;

/// @tparam Time  seconds of a plan in which every curve has a choice: double(const CurveChoice&)
template <class Time>
class ChoiceSearch {
 public:
  ChoiceSearch(const ChoiceRules& rules, Time time_of) : rules_(rules), time_of_(std::move(time_of)) {}

  /// Choices from which no other one near by is faster, of all shares with all splits; the fastest first.
  std::vector<CurveChoice> valleys() {
    const double usual = usual_split(rules_.at_cap);
    std::array<std::vector<Timed>, std::size(kSplits)> rows;
    for (std::size_t p = 0; p < std::size(kSplits); ++p) {
      const bool may_help = rules_.at_cap == AtCap::rests ? kSplits[p] <= 0.5 : kSplits[p] >= 0;
      if (kSplits[p] == usual || (rules_.has_jerk && may_help)) rows[p] = timed_shares(kSplits[p]);
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
    std::vector<CurveChoice> choices;
    for (const Timed& bottom : bottoms) choices.push_back(bottom_near(bottom));
    return choices;
  }

  /// The lowest share with the usual split, downhill from where that of the last run was: runs of a part are like each other.
  /// @param nearest  number of the share that suited the last run; which suits this one is left there
  CurveChoice nearest_valley(std::size_t& nearest) {
    const double split = usual_split(rules_.at_cap);
    std::array<double, kSharesTried> times;
    times.fill(kUnlimited);
    const auto try_at = [&](std::size_t k) {
      times[k] = time_of_({kShares[k], split});
      if (times[k] < times[nearest]) nearest = k;
    };
    const std::size_t first = nearest;
    try_at(first);
    for (std::size_t k = first; k-- > 0 && k + kInVain >= nearest;) try_at(k);
    for (std::size_t k = first + 1; k < kSharesTried && k <= nearest + kInVain; ++k) try_at(k);
    if (nearest == 0 || nearest + 1 == kSharesTried) return {kShares[nearest], split};
    const std::array<double, 3> share{kShares[nearest + 1], kShares[nearest], kShares[nearest - 1]};
    return {lowest_by_parabolas(share, {times[nearest + 1], times[nearest], times[nearest - 1]}, split), split};
  }

 private:
  /// Tried first, and how narrow the search between them becomes.
  static constexpr double kShares[] = {1.0,  0.97, 0.95, 0.93, 0.905, 0.88, 0.84, 0.8, 0.75, 0.7,
                                       0.65, 0.6,  0.55, 0.5,  0.45,  0.4,  0.35, 0.3, 0.2,  0.1};
  static constexpr double kSplits[] = {0.95, 0.85, 0.71, 0.5, 0.25, 0.1, 0.0, -0.12, -0.3};
  static constexpr double kNarrow = 0.002;
  static constexpr double kGolden = 0.6180339887498949;
  static constexpr std::size_t kMostValleys = 3;
  static constexpr std::size_t kInVain = 2;  // shares in a row on either side, where not all are tried
  static constexpr int kParabolas = 2;       // by which the lowest place is then sought
  static constexpr std::size_t kSharesTried = std::size(kShares);

  struct Timed {
    CurveChoice choice;
    double time;
  };

  /// A place that one of a row of values is, between its neighbours.
  template <std::size_t count>
  static std::pair<double, double> beside(const double (&values)[count], double value) {
    const auto* const at = std::find(std::begin(values), std::end(values), value);
    return {at + 1 == std::end(values) ? *at : at[1], at == std::begin(values) ? *at : at[-1]};
  }

  /// All shares with one split of the jerk.
  std::vector<Timed> timed_shares(double split) {
    std::vector<Timed> row;
    for (const double share : kShares) row.push_back({{share, split}, time_of_({share, split})});
    return row;
  }

  /// Near the middle one of three shares, whose time is the least.
  double lowest_by_parabolas(std::array<double, 3> share, std::array<double, 3> time, double split) {
    for (int i = 0; i < kParabolas; ++i) {
      const double low = share[1] - share[0], high = share[2] - share[1];
      const double falls = (time[0] - time[1]) / low, rises = (time[2] - time[1]) / high;
      const double x = share[1] + (falls * high - rises * low) / (2 * (falls + rises));
      if (!(x > share[0] && x < share[2]) || x == share[1]) break;
      const double now = time_of_({x, split});
      const std::size_t side = x < share[1] ? 0 : 2;
      if (now < time[1]) {
        share[2 - side] = share[1], time[2 - side] = time[1];
        share[1] = x, time[1] = now;
      } else {
        share[side] = x, time[side] = now;
      }
    }
    return share[1];
  }

  /// The fastest choice between the neighbours of one that is tried first: by one of the two, and then by the other.
  CurveChoice bottom_near(Timed start) {
    Timed best = narrowed(start, &CurveChoice::share, beside(kShares, start.choice.share));
    return rules_.has_jerk ? narrowed(best, &CurveChoice::split, beside(kSplits, start.choice.split)).choice
                           : best.choice;
  }

  Timed narrowed(Timed best, double CurveChoice::*what, std::pair<double, double> between) {
    auto [low, high] = between;
    const auto at = [&](double x) {
      Timed other = best;
      other.choice.*what = x;
      other.time = time_of_(other.choice);
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

  ChoiceRules rules_;
  Time time_of_;
};

}  // namespace toolpace::detail
